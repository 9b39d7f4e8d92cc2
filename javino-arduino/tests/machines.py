"""The reference's two state machines as graphs that a model explores: states are numbers, and each step of a machine is made once."""
import copy
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "vectors"))


def freeze(value):
    """A value that two objects share if and only if they are in the same state."""
    if isinstance(value, tuple):
        return tuple(map(freeze, value))
    if isinstance(value, list):
        return ("list", *map(freeze, value))
    if isinstance(value, dict):
        return ("dict", *sorted((key, freeze(v)) for key, v in value.items()))
    if isinstance(value, (set, frozenset)):
        return ("set", *sorted(value))
    if hasattr(value, "__dict__"):
        return (type(value).__name__, *((key, freeze(v)) for key, v in sorted(vars(value).items())))
    return value


class Machine:
    """`step(object, event)` changes the object and returns its output."""

    def __init__(self, step):
        self.step = step
        self.ids, self.objects, self.steps = {}, [], {}

    def id_of(self, thing):
        frozen = freeze(thing)
        if frozen not in self.ids:
            self.ids[frozen] = len(self.objects)
            self.objects.append(thing)
        return self.ids[frozen]

    def after(self, id, event):
        """Returns (the new state's number, the output) after an event in a state."""
        made = self.steps.get((id, event))
        if made is None:
            thing = copy.deepcopy(self.objects[id])
            out = self.step(thing, event)
            made = self.steps[id, event] = (self.id_of(thing), out)
        return made
