"""A Raspberry Pi Pico with MicroPython: a servo that reports when it has arrived, a light sensor, an LED. Save it as main.py. The line is
the first UART, pins 0 and 1; with javino.Board() it is the USB port."""
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
