package javino;

/** Which version of the Javino protocol is spoken on a line. */
public enum Protocol {
    /** Found out by asking the board; of a link: not found out yet. */
    AUTO,

    /** Version 1, which boards in the field speak: frames without a checksum, nothing is acknowledged. */
    V1,

    /** Version 2: short frames with a checksum, answers of any length, acknowledged commands, critical rules on the board. */
    V2
}
