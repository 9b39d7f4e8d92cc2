package javino.wire;

/** CRC-16/CCITT-FALSE: polynomial 0x1021, initial value 0xFFFF. A session's nonce changes the high byte of the initial value. */
final class Crc16 {
    private static final int START = 0xFFFF;
    private static final int POLYNOMIAL = 0x1021;
    private static final int TOP_BIT = 0x8000;
    private static final int[] TABLE = table();

    private int value = START;

    private static int[] table() {
        int[] table = new int[256];
        for (int i = 0; i < table.length; i++) {
            int crc = i << 8;
            for (int bit = 0; bit < 8; bit++) {
                crc = (crc & TOP_BIT) == 0 ? crc << 1 : crc << 1 ^ POLYNOMIAL;
            }
            table[i] = crc & 0xFFFF;
        }
        return table;
    }

    /** Begins the checksum of a frame. A frame outside of a session has nonce 0. */
    void reset(int nonce) {
        value = START ^ nonce << 8;
    }

    void add(int octet) {
        value = (value << 8 ^ TABLE[(value >> 8 ^ octet) & 0xFF]) & 0xFFFF;
    }

    int value() {
        return value;
    }
}
