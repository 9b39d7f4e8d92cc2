"""A small rosbridge server for a ROS 1 graph, for tests. Supports topics and services in both directions, and a part of rosapi.

    bridge.py PORT

Sends the newest message of a topic each throttle interval. Prints "ready" when it listens.
"""

import asyncio
import itertools
import json
import sys
import threading
import time

import genpy
import genpy.message
import roslib.message
import rosgraph
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
    genpy.message.fill_message_args(message, [values])
    return message


def message_class(name):
    found = roslib.message.get_message_class(name)
    if found is None:
        raise ValueError("there is no type " + name)
    return found


class Subscription:
    """Keeps the newest message of a topic, and sends it each interval."""

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


class Service:
    """Forwards calls of a service to a client."""

    def __init__(self, client, name, kind):
        self.client, self.name, self.loop = client, name, asyncio.get_running_loop()
        self.found = roslib.message.get_service_class(kind)
        if self.found is None:
            raise ValueError("there is no type " + kind)
        if name in SERVICES:  # left by a client that has disconnected
            SERVICES.pop(name).shutdown()
        SERVICES[name] = rospy.Service(name, self.found, self.ask)

    def ask(self, request):
        call, answered = "request-%d" % next(NUMBERS), threading.Event()
        values = self.client.calls[call] = {"answered": answered}
        operation = {"op": "call_service", "id": call, "service": self.name, "args": to_json(request)}
        asyncio.run_coroutine_threadsafe(self.client.answer(operation), self.loop)
        answered.wait()
        return fill(self.found._response_class(), values["values"])


class Client(WebSocketHandler):
    def open(self):
        self.subscriptions, self.publishers, self.calls = {}, {}, {}

    def on_close(self):
        for topic in list(self.subscriptions):
            self.subscriptions.pop(topic).end()
        for publisher in self.publishers.values():
            publisher.unregister()

    def check_origin(self, origin):
        return True

    async def answer(self, operation):
        try:
            await self.write_message(json.dumps(operation))
        except WebSocketClosedError:
            pass

    async def on_message(self, text):
        try:
            self.hear(json.loads(text))
        except Exception as trouble:  # a real bridge also hides these errors from its clients
            print("%s: %s" % (text[:200], trouble), flush=True)

    def hear(self, operation):
        topic = operation.get("topic")
        kind = operation["op"]
        if kind == "advertise":
            latch = operation.get("latch", False)
            self.publishers[topic] = rospy.Publisher(topic, message_class(operation["type"]), queue_size=10, latch=latch)
        elif kind == "unadvertise":
            self.publishers.pop(topic).unregister()
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
        elif kind == "advertise_service":
            Service(self, operation["service"], operation["type"])
        elif kind == "unadvertise_service":
            SERVICES.pop(operation["service"]).shutdown()
        elif kind == "service_response":
            call = self.calls.pop(operation["id"])
            call["values"] = operation["values"]
            call["answered"].set()

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


def topics(arguments):
    publishers, subscribers, _ = rosgraph.Master("/bridge").getSystemState()
    types = dict(rosgraph.Master("/bridge").getTopicTypes())
    names = sorted({name for name, _ in publishers + subscribers})
    return {"topics": names, "types": [types.get(name, "") for name in names]}


def services(arguments):
    return {"services": rosservice.get_service_list()}


KNOWN = {"/rosapi/get_time": now, "/rosapi/topics": topics, "/rosapi/services": services}
NUMBERS = itertools.count()
SERVICES = {}


async def main(port):
    rospy.init_node("bridge", disable_signals=True)
    HTTPServer(Application([("/.*", Client)])).listen(port, "127.0.0.1")
    print("ready", flush=True)
    await asyncio.Event().wait()


asyncio.run(main(int(sys.argv[1])))
