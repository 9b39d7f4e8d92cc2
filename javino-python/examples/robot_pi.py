"""A robot on a Raspberry Pi: two motors, an ultrasonic sensor and a bumper, with gpiozero. The agent's computer uses a serial cable
(/dev/serial0) or the network.

    robot_pi.py [LINE]      /dev/serial0, or tcp://0.0.0.0:4000

The agent may set critical rules, such as "stop when dist(front,_) is less than 20". This program watches the critical rules.
"""
import sys

from gpiozero import Button, DistanceSensor, Robot

import javino

robot = Robot(left=(4, 14), right=(17, 18))
sonar = DistanceSensor(echo=24, trigger=23)
bumper = Button(2)
board = javino.Board(sys.argv[1] if len(sys.argv) > 1 else "/dev/serial0", baud=115200)


@board.perceive("dist(front, cm 0..100)", "bumper(true|false)")
def look():
    if board.wants("dist"):
        board.percept("dist", "front", round(sonar.distance * 100))
    board.percept("bumper", bumper.is_pressed)


@board.on_action("drive", arguments=2)
def drive(left, right):
    """drive(-100..100, -100..100)"""
    if not (-100 <= left <= 100 and -100 <= right <= 100):
        return False  # refuses the command
    robot.value = (left / 100, right / 100)


board.act["stop"] = robot.stop
board.watch_rules()
board.on_link_lost(500, robot.stop)  # the agent or its computer has failed
board.run_forever()
