"""The roslibpy client of "./argo bench ros". Commands the nearest distance of each scan as the speed."""

import sys

import roslibpy

client = roslibpy.Ros("127.0.0.1", int(sys.argv[1]))
client.run()
scans = roslibpy.Topic(client, "/scan", "sensor_msgs/LaserScan", queue_length=1)
commands = roslibpy.Topic(client, "/cmd_vel", "geometry_msgs/Twist")
commands.advertise()


def react(scan):
    turn = {"x": 0.0, "y": 0.0, "z": 0.0}
    commands.publish(roslibpy.Message({"linear": {"x": min(scan["ranges"]), "y": 0.0, "z": 0.0}, "angular": turn}))


scans.subscribe(react)
sys.stdin.read()
