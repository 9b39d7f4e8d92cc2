"""A Raspberry Pi Pico with MicroPython: a servo that reports its arrival, a light sensor and an LED. Save this file as main.py. The
line is the first UART, pins 0 and 1. For the USB port write javino.Board()."""
from machine import ADC, PWM, UART, Pin
from time import ticks_add, ticks_diff, ticks_ms

import javino

board = javino.Board(UART(0, 115200, rxbuf=256), baud=115200, credit=255)
led = Pin(25, Pin.OUT)
light = ADC(26)
servo = PWM(Pin(15))
servo.freq(50)
turning = {"later": 0, "until": 0}

board.act["ledOn"] = led.on
board.act["ledOff"] = led.off


@board.perceive
def look():
    board.percept("light", light.read_u16() * 100 // 65535)
    board.percept("turning", turning["later"] != 0)


@board.on_action("turn", arguments=1)
def turn(degrees):
    if not 0 <= degrees <= 180:
        return False
    servo.duty_u16(1638 + degrees * 6554 // 180)
    turning["later"] = board.later()  # argo.act waits until done is called
    turning["until"] = ticks_add(ticks_ms(), 400)


def step():
    if turning["later"] and ticks_diff(ticks_ms(), turning["until"]) >= 0:
        later, turning["later"] = turning["later"], 0
        board.done(later)


board.run_forever(step)
