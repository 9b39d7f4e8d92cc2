"""A small bridge of the rosbridge protocol to a ROS 1 graph, for tests: topics in both directions, services, and a little of rosapi.

    bridge.py PORT

Sends the newest message of a topic each throttle interval. Prints "ready" when it listens.
"""

import asyncio
import json
import sys
import threading
import time

import genpy
import roslib.message
import rospy
import rosservice
from tornado.httpserver import HTTPServer
from tornado.web import Application
from tornado.websocket import WebSocketClosedError, WebSocketHandler


def to_json(value):
    if hasattr(value, "__slots__") and hasattr(value, "_slot_types"):
        return {name: to_json(getattr(value, name)) for name in value.__slots__}
    if isinstance(value, genpy.TVal):
        return {"secs": value.secs, "nsecs": value.nsecs}
    if isinstance(value, (list, tuple)):
        return [to_json(item) for item in value]
    if isinstance(value, float) and (value != value or value in (float("inf"), float("-inf"))):
        return None
    return value


def fill(message, values):
    for name, value in values.items():
        inner = getattr(message, name)
        if isinstance(value, dict) and hasattr(inner, "__slots__"):
            fill(inner, value)
        else:
            setattr(message, name, type(inner)(value) if isinstance(inner, (int, float)) else value)
    return message


def message_class(name):
    found = roslib.message.get_message_class(name)
    if found is None:
        raise ValueError("there is no type " + name)
    return found


class Subscription:
    """Keeps the newest message of a topic, and has it sent each interval."""

    def __init__(self, client, topic, kind, interval):
        self.client, self.topic, self.interval = client, topic, interval
        self.newest, self.lock = None, threading.Lock()
        self.task = asyncio.ensure_future(self.relay())
        self.subscriber = rospy.Subscriber(topic, message_class(kind), self.keep, queue_size=1)

    def keep(self, message):
        with self.lock:
            self.newest = message

    async def relay(self):
        while True:
            with self.lock:
                message, self.newest = self.newest, None
            if message is not None:
                await self.client.answer({"op": "publish", "topic": self.topic, "msg": to_json(message)})
            await asyncio.sleep(max(self.interval, 0.005))

    def end(self):
        self.task.cancel()
        self.subscriber.unregister()


class Client(WebSocketHandler):
    def open(self):
        self.subscriptions, self.publishers = {}, {}

    def on_close(self):
        for topic in list(self.subscriptions):
            self.subscriptions.pop(topic).end()

    def check_origin(self, origin):
        return True

    async def answer(self, operation):
        try:
            await self.write_message(json.dumps(operation))
        except WebSocketClosedError:
            pass

    async def on_message(self, text):
        operation = json.loads(text)
        topic = operation.get("topic")
        kind = operation["op"]
        if kind == "advertise":
            self.publishers[topic] = rospy.Publisher(topic, message_class(operation["type"]), queue_size=10)
        elif kind == "publish":
            publisher = self.publishers[topic]
            publisher.publish(fill(publisher.data_class(), operation["msg"]))
        elif kind == "subscribe":
            if topic in self.subscriptions:
                self.subscriptions.pop(topic).end()
            interval = operation.get("throttle_rate", 0) / 1000
            self.subscriptions[topic] = Subscription(self, topic, operation["type"], interval)
        elif kind == "unsubscribe":
            self.subscriptions.pop(topic).end()
        elif kind == "call_service":
            asyncio.ensure_future(self.call(operation))

    async def call(self, operation):
        service, arguments = operation["service"], operation.get("args") or {}
        try:
            known = KNOWN.get(service)
            values = known(arguments) if known else await asyncio.get_running_loop().run_in_executor(None, call, service, arguments)
            result = True
        except Exception as trouble:
            values, result = "Service %s does not exist or failed: %s" % (service, trouble), False
        await self.answer(
            {"op": "service_response", "id": operation["id"], "service": service, "values": values, "result": result})


def call(service, arguments):
    found = roslib.message.get_service_class(rosservice.get_service_type(service) or "")
    if found is None:
        raise ValueError("nobody serves it")
    return to_json(rospy.ServiceProxy(service, found)(fill(found._request_class(), arguments)))


def now(arguments):
    seconds = time.time()
    return {"time": {"secs": int(seconds), "nsecs": int(seconds % 1 * 1e9)}}


KNOWN = {"/rosapi/get_time": now}


async def main(port):
    rospy.init_node("bridge", disable_signals=True)
    HTTPServer(Application([("/.*", Client)])).listen(port, "127.0.0.1")
    print("ready", flush=True)
    await asyncio.Event().wait()


asyncio.run(main(int(sys.argv[1])))
