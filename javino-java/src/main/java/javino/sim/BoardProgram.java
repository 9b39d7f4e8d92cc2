package javino.sim;

import java.util.List;
import javino.PerceptKind;
import javino.PerceptsRequest;
import javino.PortException;
import javino.wire.BoardAction;

/** The program of a simulated board. The board's thread calls all methods. While a method runs, the board does nothing else. */
public interface BoardProgram {
    enum Outcome {
        /** The command was carried out. */
        DONE,

        /** The command is unknown, or has wrong arguments. */
        REFUSED,

        /** The command has begun, and {@link BoardSession#report} will tell its outcome. In version 1 this counts as {@link #DONE}. */
        LATER
    }

    /**
     * Returns the actions that the board reports to computers; empty by default. A computer can call an action without arguments by its
     * index in this list. Only the first 126 actions with names of at most 250 bytes count. A computer learns only the number of the
     * other actions, and sends none of them.
     */
    default List<BoardAction> vocabulary() {
        return List.of();
    }

    /** Returns the kinds of percepts that the board describes to computers of version 2; empty by default. */
    default List<PerceptKind> perceptKinds() {
        return List.of();
    }

    /** Carries out a text command. */
    Outcome carryOut(String command) throws PortException, InterruptedException;

    /**
     * Returns the answer to a request: percepts, each followed by {@code ;}.
     *
     * @param request {@code getPercepts}, or {@code getPercepts(dist,light)} for percepts with certain functors
     * @return the percepts, or null for no answer
     */
    String percepts(String request) throws PortException, InterruptedException;

    /** Returns the present percepts of the sensors, in the form of {@link #percepts}. Called every few milliseconds while rules are set. */
    default String sensors() throws PortException, InterruptedException {
        return percepts(PerceptsRequest.ALL);
    }

    /**
     * Called when the line has taken the answer to a request.
     *
     * @param requestBytes the length of the request in bytes
     * @param answerBytes the length of the answer in bytes; in version 2 the sum of all its parts
     * @param endNanos the time, by the line's clock, at which the last byte of the answer leaves the line
     */
    default void answered(int requestBytes, int answerBytes, long endNanos) {}
}
