package javino;

/** The version of the Javino protocol on a line. */
public enum Protocol {
    /** As a setting, lets the link ask the board for its version. As a link's state, means that the version is not known yet. */
    AUTO,

    /** Version 1: frames without a checksum, and no acknowledgements. */
    V1,

    /** Version 2: short frames with a checksum, messages of any length, acknowledged commands, and critical rules on the board. */
    V2
}
