"""A board with CircuitPython: the data port of USB, an LED and an analogue input. Save this file as code.py, and add to boot.py:

    import usb_cdc
    usb_cdc.enable(console=True, data=True)
"""
import analogio
import board as pins
import digitalio
import usb_cdc

import javino

led = digitalio.DigitalInOut(pins.LED)
led.direction = digitalio.Direction.OUTPUT
light = analogio.AnalogIn(pins.A0)

board = javino.Board(usb_cdc.data)


@board.on_action("led", arguments=1)
def set_led(state):
    if state not in ("on", "off"):
        return False
    led.value = state == "on"


@board.perceive
def look():
    board.percept("light", light.value * 100 // 65535)


board.run_forever()
