"""Prints messages of random types of ROS 2, as rosbags and Cyclone DDS write them in CDR: python cdr.py SEED COUNT.

Each line is a JSON object. "schema" is the type as a bag describes it. "bytes" has the message in hex, by the program that wrote it.
"json" is the message as a rosbridge returns it.
"""

import base64
import json
import math
import random
import sys

import numpy
from cyclonedds.idl import make_idl_struct, types as idl
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

SEPARATOR = "\n" + "=" * 80 + "\n"
INTEGERS = {f"{sign}int{bits}": (sign, bits) for sign in ("", "u") for bits in (8, 16, 32, 64)}
PRIMITIVES = ["bool", "float32", "float64", "string", *INTEGERS]
TEXTS = ["", "a", "go", "stop \u2603", "C:\\robot", "two\nlines", "\u00fc" * 3]


class Maker:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.structs = []  # (name, [(field, type, length, bound)]), those within others first

    def struct(self, name, depth):
        fields = []
        for number in range(self.random.randint(1, 6)):
            kind = self.random.choice(PRIMITIVES + ["inner"] * 3)
            if kind == "inner":
                if depth == 2:
                    kind = "int16"
                elif self.structs and self.random.random() < 0.5:
                    kind = self.random.choice(self.structs)[0]
                else:
                    kind = self.struct(f"{name}{number}", depth + 1)
            length = self.random.choice([None, None, None, "open", "bound", self.random.randint(1, 4)])
            fields.append((f"f{number}", kind, length))
        self.structs.append((name, fields))
        return name

    def value(self, kind):
        if kind == "bool":
            return self.random.random() < 0.5
        if kind == "string":
            return self.random.choice(TEXTS)
        if kind.startswith("float"):
            value = self.random.choice([0.0, -1.5, 0.1, 1e30, math.inf, math.nan, self.random.random()])
            return float(numpy.float32(value)) if kind == "float32" else value
        if kind in INTEGERS:
            sign, bits = INTEGERS[kind]
            low = 0 if sign else -(2 ** (bits - 1))
            return self.random.choice([low, low + 2**bits - 1, 0, 7])
        return {field: self.values(inner, length) for field, inner, length in dict(self.structs)[kind]}

    def values(self, kind, length):
        if length is None:
            return self.value(kind)
        return [self.value(kind) for _ in range(length if isinstance(length, int) else self.random.randint(0, 3))]


def definition(fields):
    lines = ["# a comment = no constant", 'string NAME="a # b"  # told', "int8 LIMIT=-5"]
    for field, kind, length in fields:
        written = f"my_msgs/{kind}" if kind[0].isupper() else kind
        brackets = {None: "", "open": "[]", "bound": "[<=5]"}.get(length, f"[{length}]")
        lines.append(f"{written}{brackets} {field}  # {kind}")
    return "\n".join(lines)


def as_json(value, kind, length, structs):
    if length is not None:
        if kind == "uint8":
            return base64.b64encode(bytes(value)).decode()
        return [as_json(item, kind, None, structs) for item in value]
    if kind.startswith("float"):
        return value if math.isfinite(value) else None
    if kind in structs:
        return {field: as_json(value[field], inner, size, structs) for field, inner, size in structs[kind]}
    return value


def by_rosbags(store, structs, value, kind, length):
    if length is not None:
        items = [by_rosbags(store, structs, item, kind, None) for item in value]
        if kind in structs or kind == "string":
            return items
        return numpy.array(items, dtype=numpy.dtype("?" if kind == "bool" else kind))
    if kind not in structs:
        return value
    fields = {field: by_rosbags(store, structs, value[field], inner, size) for field, inner, size in structs[kind]}
    return store.types[f"my_msgs/msg/{kind}"](**fields)


def by_cyclone(classes, structs, value, kind, length):
    if length is not None:
        return [by_cyclone(classes, structs, item, kind, None) for item in value]
    if kind not in structs:
        return value
    return classes[kind](**{field: by_cyclone(classes, structs, value[field], inner, size) for field, inner, size in structs[kind]})


def classes_of(structs):
    plain = {"bool": bool, "string": str}
    classes = {}
    for name, fields in structs.items():
        annotations = {}
        for field, kind, length in fields:
            one = classes.get(kind) or plain.get(kind) or getattr(idl, kind)
            sizes = {"open": lambda: idl.sequence[one], "bound": lambda: idl.sequence[one, 5]}
            annotations[field] = one if length is None else sizes.get(length, lambda: idl.array[one, length])()
        classes[name] = make_idl_struct(name, f"my_msgs.{name}", annotations)
    return classes


def line(seed):
    maker = Maker(seed)
    maker.struct("A", 0)
    structs = dict(maker.structs)
    texts = {name: definition(fields) for name, fields in maker.structs}
    names = ["A"] + [name for name in texts if name != "A"]
    schema = SEPARATOR.join([texts["A"]] + [f"MSG: my_msgs/{name}\n{texts[name]}" for name in names[1:]])
    value = maker.values("A", None)
    store = get_typestore(Stores.EMPTY)
    for name, text in texts.items():
        store.register(get_types_from_msg(text, f"my_msgs/msg/{name}"))
    message = by_rosbags(store, structs, value, "A", None)
    found = {
        f"rosbags {order}": bytes(store.serialize_cdr(message, "my_msgs/msg/A", little_endian=order == "little")).hex()
        for order in ("little", "big")
    }
    other = by_cyclone(classes_of(structs), structs, value, "A", None)
    found["Cyclone"] = bytes(other.serialize(use_version_2=False)).hex()
    return json.dumps({"schema": schema, "bytes": found, "json": as_json(value, "A", None, structs)})


if __name__ == "__main__":
    first, count = int(sys.argv[1]), int(sys.argv[2])
    for number in range(first, first + count):
        print(line(number))
