"""The core in C as a program of its own, on this machine or on another processor.

The program is driven/board.c. A record to it is a letter, a flag, the time in ms (2 bytes), a length (2 bytes), bytes:

    n  a new board; the flag: bytes for rules        c  the checksum of the bytes is sent
    b  bytes that arrive at the board                e  a frame of version 1 with this payload is sent
    p  the percepts' texts                           E  a frame of version 2 of CC SS payload, in the session whose nonce is the flag
    u  they are sent unasked                         s  a new decoder, in the session whose nonce is the flag
    d  the outcome of the action begun last          r  bytes that arrive at the decoder
    l  a look at the percepts for the rules

The answer to each has bytes that are sent, and texts that are carried out or found, each with a length of 2 bytes in front. A decoder sends
the frames of version 2 that it finds: length CC SS payload. All numbers have their lowest byte first.
"""
import pathlib
import struct
import subprocess
import tempfile


def record(what, now=0, data=b"", flag=0):
    return struct.pack("<cBHH", what, flag, now & 0xFFFF, len(data)) + data


def answers(program, records):
    """What the program answers to the records: a list of (bytes sent, texts carried out or found).

    program  its words, or the name of an .ihx file for an 8051, which is simulated
    """
    on_8051 = program[0].endswith(".ihx")
    data = b"".join(records)
    output = output_of_8051(program[0], data) if on_8051 else subprocess.run(program, input=data, stdout=subprocess.PIPE).stdout
    found = list(parse(output))
    if len(found) != len(records):
        raise SystemExit(f"{program[0]} gave {len(found)} answers to {len(records)} records")
    return found


def output_of_8051(program, data):
    with tempfile.TemporaryDirectory() as folder:
        taken, given = pathlib.Path(folder, "in"), pathlib.Path(folder, "out")
        taken.write_bytes(data)
        console = subprocess.PIPE  # the simulator ends with its console
        with subprocess.Popen(["s51", "-t", "52", "-G", "-I", f"if=xram[0xffff],in={taken},out={given}", program], stdin=console,
                              stdout=subprocess.DEVNULL) as simulator:
            simulator.wait()
        return given.read_bytes()


def parse(output):
    at = 0

    def field():
        nonlocal at
        begin = at + 2
        at = begin + struct.unpack_from("<H", output, at)[0]
        return output[begin:at]

    while at < len(output):
        sent, carried, texts = field(), field(), []
        while carried:
            texts.append(carried[1:1 + carried[0]])
            carried = carried[1 + carried[0]:]
        yield sent, texts
