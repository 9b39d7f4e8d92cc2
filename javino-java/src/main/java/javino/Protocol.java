package javino;

/** Which version of the Javino protocol is spoken on a line. */
public enum Protocol {
    /** Found out by asking the board; of a link: not found out yet. */
    AUTO,

    /** Version 1, which boards in the field speak: frames without a checksum, nothing is acknowledged. */
    V1,

    /** Version 2: frames with a checksum, messages of any length, acknowledged actions. */
    V2;

    boolean reads(int version) {
        return this == AUTO || ordinal() == version;
    }
}
