package javino;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The request for percepts. {@code getPercepts} asks for all percepts. {@code getPercepts(dist,light)} asks a board of version 2 only for
 * percepts with these functors.
 */
public final class PerceptsRequest {
    /** Asks for all percepts. Every board answers this request. No board treats this request as an action. */
    public static final String ALL = "getPercepts";

    /** Asks a board of version 2 for the kinds of its percepts. A board that cannot describe kinds takes the {@code ?} for a functor. */
    public static final String KINDS = ALL + "(?)";

    private static final String SOME = ALL + "(";

    private PerceptsRequest() {}

    /** Returns whether {@code message} is a request for percepts. */
    public static boolean isIn(String message) {
        return message.equals(ALL) || message.startsWith(SOME);
    }

    /** Returns the functors that {@code message} asks for. An empty result means all percepts. */
    public static Set<String> functorsIn(String message) {
        if (!message.startsWith(SOME)) {
            return Set.of();
        }
        String names =
                message.substring(SOME.length(), message.endsWith(")") ? message.length() - 1 : message.length());
        return Arrays.stream(names.split(",")).filter(name -> !name.isBlank()).collect(Collectors.toUnmodifiableSet());
    }
}
