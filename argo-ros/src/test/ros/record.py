"""Forwards messages between one client and a bridge, and records them as JSON lines for TranscriptBridge.

    record.py PORT BRIDGE_PORT FILE

Each line has the time in ms since the client connected, the sender and the message: {"ms": 12, "from": "bridge", "message": {…}}. Ends when
the client or the bridge disconnects.
"""

import asyncio
import json
import sys
import time

from tornado.httpserver import HTTPServer
from tornado.web import Application
from tornado.websocket import WebSocketHandler, websocket_connect


class Between(WebSocketHandler):
    async def open(self):
        self.begun = time.monotonic()
        self.bridge = await websocket_connect("ws://127.0.0.1:%d/" % self.settings["bridge"])
        self.file = open(self.settings["file"], "w", buffering=1, encoding="utf-8")
        self.relaying = asyncio.ensure_future(self.relay())

    async def relay(self):
        while (message := await self.bridge.read_message()) is not None:
            self.note("bridge", message)
            await self.write_message(message)
        self.close()

    async def on_message(self, message):
        while not hasattr(self, "relaying"):
            await asyncio.sleep(0.001)
        self.note("client", message)
        await self.bridge.write_message(message)

    def note(self, sender, message):
        ms = round((time.monotonic() - self.begun) * 1000)
        line = {"ms": ms, "from": sender, "message": json.loads(message)}
        self.file.write(json.dumps(line, separators=(",", ":")) + "\n")

    def on_close(self):
        self.file.close()
        self.settings["done"].set_result(None)

    def check_origin(self, origin):
        return True


async def main(port, bridge, file):
    done = asyncio.get_running_loop().create_future()
    HTTPServer(Application([("/.*", Between)], bridge=bridge, file=file, done=done)).listen(port, "127.0.0.1")
    await done


asyncio.run(main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]))
