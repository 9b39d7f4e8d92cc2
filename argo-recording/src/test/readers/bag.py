"""Writes the bags of src/test/resources/bags: python bag.py FOLDER.

rosbags writes one bag. mcap writes copies of it with other compressions.
"""

import pathlib
import shutil
import sys
import tempfile

import numpy as np
from mcap.reader import make_reader
from mcap.writer import CompressionType
from mcap.writer import Writer as McapWriter
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

store = get_typestore(Stores.ROS2_HUMBLE)


def make(kind, **fields):
    return store.types[kind](**fields)


def header(ns):
    stamp = make("builtin_interfaces/msg/Time", sec=ns // 10**9, nanosec=ns % 10**9)
    return make("std_msgs/msg/Header", stamp=stamp, frame_id="sonar")


def write(folder):
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as bag:
        topics = {}

        def say(topic, kind, ns, **fields):
            if topic not in topics:
                topics[topic] = bag.add_connection(topic, kind, typestore=store)
            bag.write(topics[topic], ns, store.serialize_cdr(make(kind, **fields), kind))

        for i in range(10):
            ns = 1_700_000_000_000_000_000 + i * 100_000_000
            limits = {"radiation_type": 0, "field_of_view": 0.1, "min_range": 0.02, "max_range": 4.0}
            say("/sonar", "sensor_msgs/msg/Range", ns, header=header(ns), range=1.0 - i / 10, **limits)
            if i % 5 == 0:
                say("/said", "std_msgs/msg/String", ns + 1, data="stop \u2603" if i else "go")
                ranges = np.array([1.5, float("inf"), float("nan")], dtype=np.float32)
                angles = {"angle_min": 0.0, "angle_max": 1.0, "angle_increment": 0.5, "time_increment": 0.0, "scan_time": 0.1}
                rest = {"range_min": 0.0, "range_max": 9.0, "intensities": np.array([], dtype=np.float32)}
                say("/scan", "sensor_msgs/msg/LaserScan", ns + 2, header=header(ns), ranges=ranges, **angles, **rest)
        say("/tick", "std_msgs/msg/Empty", ns + 3)
        pixels = np.array([1, 2, 255], dtype=np.uint8)
        size = {"height": 1, "width": 3, "encoding": "mono8", "is_bigendian": 0, "step": 3}
        say("/image", "sensor_msgs/msg/Image", ns + 4, header=header(ns), data=pixels, **size)


def rewrite(source, target, compression):
    with open(source, "rb") as read, open(target, "wb") as written:
        writer = McapWriter(written, compression=compression)
        writer.start()
        schemas, channels = {}, {}
        for schema, channel, message in make_reader(read).iter_messages():
            if schema.id not in schemas:
                schemas[schema.id] = writer.register_schema(schema.name, schema.encoding, schema.data)
            if channel.id not in channels:
                of = schemas[schema.id]
                channels[channel.id] = writer.register_channel(channel.topic, channel.message_encoding, of, channel.metadata)
            writer.add_message(channels[channel.id], message.log_time, message.data, message.publish_time, message.sequence)
        writer.finish()


def write_odd(target):
    """Writes a bag with unreadable messages. They are cut off, or have a type in another language, or have another encoding."""
    with open(target, "wb") as written:
        writer = McapWriter(written, compression=CompressionType.NONE)
        writer.start()
        string = writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        other = writer.register_schema("my_msgs/msg/A", "ros2idl", b"module my_msgs {}")
        said = writer.register_channel("/said", "cdr", string)
        for i, data in enumerate(["00010000" "02000000" "6100", "00010000" "ff000000" "61", "00010000" "02000000" "6200"]):
            writer.add_message(said, i * 10**9, bytes.fromhex(data), i * 10**9, i)
        writer.add_message(writer.register_channel("/idl", "cdr", other), 3 * 10**9, b"\x00\x01", 0, 0)
        writer.add_message(writer.register_channel("/text", "json", 0), 3 * 10**9, b"{}", 0, 0)
        writer.finish()


if __name__ == "__main__":
    bags = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as place:
        write(pathlib.Path(place, "bag"))
        shutil.copy(pathlib.Path(place, "bag", "bag.mcap"), bags / "rosbags.mcap")
    for compression in CompressionType.ZSTD, CompressionType.LZ4:
        rewrite(bags / "rosbags.mcap", bags / f"{compression.name.lower()}.mcap", compression)
    write_odd(bags / "odd.mcap")
