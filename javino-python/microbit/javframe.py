# Returns the length of the frame at the start. Returns 6 while the header is incomplete, and 0 if there is no frame.
def length(data):
    head = data[:4]
    if head != b"fffe"[:len(head)]:
        return 0
    if len(data) < 6:
        return 6
    size = 0
    for b in data[4:6]:
        at = "0123456789ABCDEFabcdef".find(chr(b))
        if at < 0:
            return 0
        size = 16 * size + (at if at < 16 else at - 6)
    return 6 + size


# Returns three values: the data from the first frame on, the frame's length (0 if incomplete), and whether a frame or silence follows
# it.
def find(data, silence):
    while data:
        size = length(data)
        if size and len(data) < size:
            if silence < 100:
                break
        elif size:
            rest = data[size:size + 4]
            sure = rest == b"fffe"[:len(rest)]
            if sure and len(rest) < 4 and silence < 6:
                break
            return data, size, sure
        data = data[1:]
    return data, 0, False
