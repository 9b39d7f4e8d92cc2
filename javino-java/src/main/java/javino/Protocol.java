package javino;

/** The version of the Javino protocol that is spoken on a line. */
public enum Protocol {
    /** As a setting, it makes the link ask the board for its version. As the state of a link, it says that the version is not known yet. */
    AUTO,

    /** Version 1, which boards in the field speak: frames have no checksum, and nothing is acknowledged. */
    V1,

    /** Version 2: short frames with a checksum, answers of any length, acknowledged commands, critical rules on the board. */
    V2
}
