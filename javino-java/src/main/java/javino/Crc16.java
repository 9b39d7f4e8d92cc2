package javino;

/** CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, not reflected, no final xor; of "123456789" it is 0x29B1. */
final class Crc16 {
    private static final int POLYNOMIAL = 0x1021;
    private static final int START = 0xFFFF;
    private static final int[] OF_BYTE = new int[256];

    static {
        for (int b = 0; b < OF_BYTE.length; b++) {
            int crc = b << 8;
            for (int bit = 0; bit < 8; bit++) {
                crc = crc << 1 ^ ((crc & 0x8000) != 0 ? POLYNOMIAL : 0);
            }
            OF_BYTE[b] = crc & 0xFFFF;
        }
    }

    private Crc16() {}

    /** The checksum of {@code length} bytes from {@code offset}, 0 to 0xFFFF. */
    static int of(byte[] bytes, int offset, int length) {
        int crc = START;
        for (int i = offset; i < offset + length; i++) {
            crc = (crc << 8 ^ OF_BYTE[(crc >> 8 ^ bytes[i]) & 0xFF]) & 0xFFFF;
        }
        return crc;
    }
}
