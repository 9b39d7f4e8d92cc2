package javino;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The request for percepts: {@code getPercepts} asks for all, {@code getPercepts(dist,light)} asks a board of version 2 for the percepts of
 * some functors.
 */
public final class PerceptsRequest {
    /** Asks for all percepts. Every board answers this request; no board takes it for an action. */
    public static final String ALL = "getPercepts";

    /**
     * Asks a board of version 2 for the kinds of its percepts. A board that cannot describe kinds reads this as a request for percepts of
     * some functors.
     */
    public static final String KINDS = ALL + "(?)";

    private static final String SOME = ALL + "(";

    private PerceptsRequest() {}

    /** Returns whether {@code message} asks for percepts, all or some. */
    public static boolean isIn(String message) {
        return message.equals(ALL) || message.startsWith(SOME);
    }

    /** The functors that {@code message} asks for; empty: all. */
    public static Set<String> functorsIn(String message) {
        if (!message.startsWith(SOME)) {
            return Set.of();
        }
        String names =
                message.substring(SOME.length(), message.endsWith(")") ? message.length() - 1 : message.length());
        return Arrays.stream(names.split(",")).filter(name -> !name.isBlank()).collect(Collectors.toUnmodifiableSet());
    }
}
