"""A client of roslibpy: reads a board's messages, has it act in every way, and prints all that it saw as JSON.

    roslibpy_client.py PORT MESSAGES
"""

import json
import sys
import threading
import time

import roslibpy
from roslibpy.core import ActionClient, Goal
from roslibpy.ros1 import actionlib

LIMIT_S = 60


def main(port, wanted):
    ros = roslibpy.Ros("127.0.0.1", port)
    ros.run(timeout=LIMIT_S)
    seen = {"topics": sorted(ros.get_topics()), "type": ros.get_topic_type("/uno/count")}
    seen["services"] = sorted(name for name in ros.get_services() if name.startswith("/uno/"))
    seen["fields"] = ros.get_message_details("std_msgs/Float64")["typedefs"][0]["fieldnames"]
    seen["hasTime"] = ros.get_time()["secs"] > 0

    counts, enough = [], threading.Event()

    def count(message):
        counts.append(message["data"])
        if len(counts) >= wanted:
            enough.set()

    begun = time.monotonic()
    topic = roslibpy.Topic(ros, "/uno/count", "std_msgs/Float64", throttle_rate=20, queue_length=1)
    topic.subscribe(count)

    seen["service"] = dict(roslibpy.Service(ros, "/uno/blink", "argo_msgs/Command").call(
        roslibpy.ServiceRequest({"arguments": [1]}), timeout=LIMIT_S))

    results = []
    client = ActionClient(ros, "/uno/blink", "argo_msgs/action/Command")
    goal = client.send_goal(Goal({"arguments": [2]}), results.append, lambda feedback: None, results.append)
    client.wait_goal(goal, LIMIT_S)
    seen["action"] = [dict(result["values"]) for result in results]

    one = actionlib.ActionClient(ros, "/uno/blink", "argo_msgs/CommandAction")
    old = actionlib.Goal(one, roslibpy.Message({"arguments": [3]}))
    old.send()
    seen["oldAction"] = dict(old.wait(LIMIT_S))
    one.dispose()

    publisher = roslibpy.Topic(ros, "/uno/blink/command", "std_msgs/Int32")
    publisher.publish(roslibpy.Message({"data": 4}))

    try:
        roslibpy.Service(ros, "/nobody/blink", "std_srvs/Trigger").call(roslibpy.ServiceRequest(), timeout=LIMIT_S)
    except Exception as refused:
        seen["refusal"] = str(refused)

    seen["enough"] = enough.wait(LIMIT_S)
    seen["perSecond"] = len(counts) / (time.monotonic() - begun)
    seen["increasing"] = all(a < b for a, b in zip(counts, counts[1:]))
    topic.unsubscribe()
    print(json.dumps(seen))
    sys.stdout.flush()
    ros.terminate()


main(int(sys.argv[1]), int(sys.argv[2]))
