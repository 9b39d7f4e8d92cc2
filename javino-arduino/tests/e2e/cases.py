"""The common part of the end-to-end cases of boards in C and in Python."""


def check(condition, what):
    if not condition:
        raise AssertionError(what)


def equal(found, expected):
    check(found == expected, f"found {found!r}, expected {expected!r}")


def damage_one_in_200(rng, count):
    """Damages one byte in 200; count[0] has the number of damaged bytes."""
    def damage(data):
        damaged = bytearray(data)
        for i in range(len(damaged)):
            if rng.randrange(200) == 0:
                damaged[i] ^= rng.randrange(1, 256)
                count[0] += 1
        return bytes(damaged)
    return damage


def texts(rng):
    """Yields the texts of commands, without an end."""
    while True:
        yield rng.choice(["led", "ledOn", "stop", f"speed({rng.randrange(10, 251)})"])
