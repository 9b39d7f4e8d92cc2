"""Uses the board /uno of a ROS 1 graph with the ROS tools and actionlib. Prints all results as JSON."""

import json
import subprocess

import actionlib
import rospy
from argo_msgs.msg import ActAction, ActGoal

LIMIT_S = 60


def tool(*words):
    command = ["/usr/bin/python3", "/usr/bin/" + words[0], *words[1:]]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=LIMIT_S)
    return done.stdout.strip()


seen = {
    "topics": tool("rostopic", "list").split(),
    "services": tool("rosservice", "list").split(),
    "type": tool("rostopic", "type", "/uno/count"),
    "port": tool("rostopic", "echo", "-n", "1", "/uno/port"),  # was published once, before the first subscription
    "count": tool("rostopic", "echo", "-n", "1", "/uno/count/data"),
    "stop": tool("rosservice", "call", "/uno/stop"),
    "blink": tool("rosservice", "call", "/uno/blink", "['1']"),
    "act": tool("rosservice", "call", "/uno/act", "blink(2)"),
    "refused": tool("rosservice", "call", "/uno/act", "fly"),
}
tool("rostopic", "pub", "-1", "/uno/blink/command", "std_msgs/Float64", "3")
rospy.init_node("client", disable_signals=True)
client = actionlib.SimpleActionClient("/uno/act", ActAction)
seen["server"] = client.wait_for_server(rospy.Duration(LIMIT_S))
seen["states"] = [client.send_goal_and_wait(ActGoal(command), rospy.Duration(LIMIT_S)) for command in ("blink(4)", "fly")]
seen["result"] = client.get_result().message
print(json.dumps(seen))
