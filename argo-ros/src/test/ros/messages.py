"""Makes the Python modules of a ROS 1 package, as catkin does: messages, services, actions, and the package's own modules."""

import pathlib
import shutil
import sys

import actionlib_msgs.msg
import std_msgs.msg
from genpy.generator import MsgGenerator, SrvGenerator
from genpy.generate_initpy import write_modules

STAMPED = "std_msgs/Header header\nactionlib_msgs/%s\n"

source, output = map(pathlib.Path, sys.argv[1:])
NAME = source.name
texts, package = output / "texts" / NAME, output / NAME


def text_of(folder, name, text):
    file = texts / folder / (name + ".msg")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    return str(file)


for kind in (std_msgs.msg.Header, actionlib_msgs.msg.GoalID, actionlib_msgs.msg.GoalStatus):
    package_name, name = kind._type.split("/")
    text_of(package_name, name, kind._full_text.split("=" * 80)[0])

messages = [text_of(NAME, file.stem, file.read_text()) for file in (source / "msg").glob("*.msg")]
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
if (source / "src" / NAME).is_dir():
    shutil.copytree(source / "src" / NAME, package)
else:
    package.mkdir()
    (package / "__init__.py").write_text("")
for generator, files, folder in (
        (MsgGenerator(), messages, "msg"), (SrvGenerator(), [str(file) for file in (source / "srv").glob("*.srv")], "srv")):
    (package / folder).mkdir()
    if generator.generate_messages(NAME, files, str(package / folder), search) != 0:
        sys.exit("the messages of %s cannot be made" % NAME)
    write_modules(str(package / folder))
