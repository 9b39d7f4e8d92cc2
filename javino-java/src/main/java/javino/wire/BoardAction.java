package javino.wire;

/**
 * An action that a board's program has registered.
 *
 * @param arguments the number of the action's arguments, 0 to 254; {@link #ANY}: any number
 */
public record BoardAction(String name, int arguments) {
    /** Any number of arguments. */
    public static final int ANY = 0xFF;
}
