"""Makes the Python modules of the ROS 1 package argo_msgs, as catkin does.

    messages.py PACKAGE_FOLDER OUTPUT_FOLDER
"""

import pathlib
import sys

import actionlib_msgs.msg
import std_msgs.msg
from genpy.generator import MsgGenerator, SrvGenerator
from genpy.generate_initpy import write_modules

NAME = "argo_msgs"
STAMPED = "std_msgs/Header header\nactionlib_msgs/%s\n"

source, output = map(pathlib.Path, sys.argv[1:])
texts, package = output / "texts", output / NAME


def text_of(folder, name, text):
    file = texts / folder / (name + ".msg")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    return str(file)


for kind in (std_msgs.msg.Header, actionlib_msgs.msg.GoalID, actionlib_msgs.msg.GoalStatus):
    package_name, name = kind._type.split("/")
    text_of(package_name, name, kind._full_text.split("=" * 80)[0])

messages = []
for action in (source / "action").glob("*.action"):
    name = action.stem
    parts = dict(zip(("Goal", "Result", "Feedback"), action.read_text().split("---")))
    parts["ActionGoal"] = STAMPED % "GoalID goal_id" + "%sGoal goal\n" % name
    parts["ActionResult"] = STAMPED % "GoalStatus status" + "%sResult result\n" % name
    parts["ActionFeedback"] = STAMPED % "GoalStatus status" + "%sFeedback feedback\n" % name
    parts["Action"] = "".join("%s%s %s\n" % (name, part, field) for part, field in (
        ("ActionGoal", "action_goal"), ("ActionResult", "action_result"), ("ActionFeedback", "action_feedback")))
    messages += [text_of(NAME, name + part, text) for part, text in parts.items()]

search = {folder.name: [str(folder)] for folder in texts.iterdir()}
package.mkdir(parents=True)
(package / "__init__.py").write_text("")
for generator, files, folder in (
        (MsgGenerator(), messages, "msg"), (SrvGenerator(), [str(file) for file in (source / "srv").glob("*.srv")], "srv")):
    (package / folder).mkdir()
    if generator.generate_messages(NAME, files, str(package / folder), search) != 0:
        sys.exit("the messages of %s cannot be made" % NAME)
    write_modules(str(package / folder))
