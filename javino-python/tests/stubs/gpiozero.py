"""The part of gpiozero that the examples use."""


class Robot:
    def __init__(self, left, right):
        self.value = (0, 0)

    def stop(self):
        self.value = (0, 0)


class DistanceSensor:
    distance = 0.5

    def __init__(self, echo, trigger):
        pass


class Button:
    is_pressed = False

    def __init__(self, pin):
        pass


class LED:
    def __init__(self, pin):
        self.is_lit = False

    def on(self):
        self.is_lit = True

    def off(self):
        self.is_lit = False


class LightSensor:
    value = 0.25

    def __init__(self, pin):
        pass
