package javino.sim;

import java.util.List;
import javino.PerceptKind;
import javino.PerceptsRequest;
import javino.PortException;
import javino.wire.BoardAction;

/**
 * The program of a simulated board, as a sketch is that of a real one. All methods are called on the board's thread and may take their
 * time; the board does nothing else meanwhile.
 */
public interface BoardProgram {
    /** The outcome of a command. */
    enum Outcome {
        /** The command was carried out. */
        DONE,

        /** The command is unknown, or has wrong arguments. */
        REFUSED,

        /** The command was begun; {@link BoardSession#report} follows. In version 1 the same as {@link #DONE}. */
        LATER
    }

    /**
     * The actions that it reports to computers; empty: it reports none. Actions without arguments may be called by their place in this
     * list. Only the first 126 actions with names of at most 250 bytes count. A computer is told how many others there are, and sends none
     * of them.
     */
    default List<BoardAction> vocabulary() {
        return List.of();
    }

    /** The kinds of percepts that it describes to computers of version 2; empty: it describes none. */
    default List<PerceptKind> perceptKinds() {
        return List.of();
    }

    /** Carries out a command, given as text. */
    Outcome carryOut(String command) throws PortException, InterruptedException;

    /**
     * The answer to a request for percepts, each with a {@code ;} behind it.
     *
     * @param request {@code getPercepts}, or {@code getPercepts(dist,light)} for the percepts of some functors
     * @return null: no answer
     */
    String percepts(String request) throws PortException, InterruptedException;

    /**
     * The percepts that the sensors show now, in the form of {@link #percepts}; called every few milliseconds while the board watches
     * rules.
     */
    default String sensors() throws PortException, InterruptedException {
        return percepts(PerceptsRequest.ALL);
    }

    /** Is called with the numbers of bytes when the answer to a request has been given to the line. */
    default void answered(int requestBytes, int answerBytes) {}
}
