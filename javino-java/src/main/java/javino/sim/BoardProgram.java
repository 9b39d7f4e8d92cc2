package javino.sim;

import java.util.List;
import javino.PerceptKind;
import javino.PerceptsRequest;
import javino.PortException;
import javino.wire.BoardAction;

/**
 * The program of a simulated board, like the sketch of a real one. The board's thread calls all methods. A method may take long; the board
 * does nothing else in that time.
 */
public interface BoardProgram {
    enum Outcome {
        /** The command was carried out. */
        DONE,

        /** The command is unknown, or has wrong arguments. */
        REFUSED,

        /** The command was begun, and {@link BoardSession#report} will tell its outcome. In version 1 this counts as {@link #DONE}. */
        LATER
    }

    /**
     * The actions that the board reports to computers; empty: none. Computers may call actions without arguments by their index in this
     * list. Only the first 126 actions with names of at most 250 bytes count. A computer learns how many actions are left out, and sends
     * none of these.
     */
    default List<BoardAction> vocabulary() {
        return List.of();
    }

    /** The kinds of percepts that the board describes to computers of version 2; empty: none. */
    default List<PerceptKind> perceptKinds() {
        return List.of();
    }

    /** Carries out a command, given as text. */
    Outcome carryOut(String command) throws PortException, InterruptedException;

    /**
     * Returns the answer to a request: percepts, each with a {@code ;} behind it.
     *
     * @param request {@code getPercepts}, or {@code getPercepts(dist,light)} for the percepts of some functors
     * @return null: no answer
     */
    String percepts(String request) throws PortException, InterruptedException;

    /** The percepts that the sensors show now, as {@link #percepts} returns them. Called every few ms while rules are set. */
    default String sensors() throws PortException, InterruptedException {
        return percepts(PerceptsRequest.ALL);
    }

    /**
     * Called when the line has taken the answer to a request.
     *
     * @param requestBytes the length of the request in bytes
     * @param answerBytes the length of the answer in bytes; in version 2 the sum of all its parts
     * @param endNanos the time by the line's clock at which the last byte of the answer leaves the line
     */
    default void answered(int requestBytes, int answerBytes, long endNanos) {}
}
