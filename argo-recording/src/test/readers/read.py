"""Prints what the reader of PyPI's mcap finds in a file: python read.py whole|cut FILE."""

import sys

from mcap.reader import make_reader
from mcap.records import Attachment, Channel, Message, Metadata
from mcap.stream_reader import StreamReader


def line(topic, message):
    return f"{topic} {message.sequence} {message.log_time} {message.data.decode()}"


def whole(file):
    """Reads the file by the index at its end."""
    reader = make_reader(file, validate_crcs=True)
    for schema, channel, message in reader.iter_messages(log_time_order=False):
        assert schema.encoding == "jsonschema" and channel.message_encoding == "json"
        print(line(channel.topic, message))
    for attachment in reader.iter_attachments():
        print(f"attachment {attachment.name} {attachment.media_type} {attachment.data.decode()}")
    for metadata in reader.iter_metadata():
        print(f"metadata {metadata.name} {sorted(metadata.metadata.items())[0][1]}")
    print(f"count {reader.get_summary().statistics.message_count}")


def cut(file):
    """Reads the file from its beginning, until it ends within a record."""
    channels = {}
    try:
        for record in StreamReader(file, validate_crcs=True).records:
            if isinstance(record, Channel):
                channels[record.id] = record.topic
            if isinstance(record, Message):
                print(line(channels[record.channel_id], record))
            if isinstance(record, Attachment):
                print(f"attachment {record.name} {record.media_type} {record.data.decode()}")
            if isinstance(record, Metadata):
                print(f"metadata {record.name} {sorted(record.metadata.items())[0][1]}")
    except Exception as end:
        print(f"ended: {type(end).__name__}", file=sys.stderr)


with open(sys.argv[2], "rb") as opened:
    {"whole": whole, "cut": cut}[sys.argv[1]](opened)
