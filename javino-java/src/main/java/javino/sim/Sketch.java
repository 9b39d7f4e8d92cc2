package javino.sim;

import java.util.List;
import javino.PerceptKind;
import javino.PortException;
import javino.Transport;

/**
 * A board in a program, as two functions: one returns percepts, one carries out commands. It speaks both versions of the protocol.
 *
 * <p>As any {@link SimulatedBoard} it is the port {@code sim:NAME} once its class is named in
 * {@code META-INF/services/javino.sim.SimulatedBoard}, or {@code SimulatedBoards.plugIn("NAME", sketch)} has been called. One object serves
 * the port however often it is opened. Both functions are called on the board's thread, one at a time, and may take their time: the board
 * does nothing else meanwhile. An exception of theirs takes the port away from its owner, who gets it in the message.
 */
public interface Sketch extends SimulatedBoard {
    /**
     * Returns the percepts that the sensors show now; called for each request.
     *
     * @return the percepts, each a literal as {@code dist(front,30)}, without a {@code ;}
     */
    List<String> percepts();

    /**
     * Returns the kinds of its percepts, which tools, checks and the live view read: {@code
     * PerceptKind.parseLines("dist(front|left, cm 0..400)")}. Unless overridden, it describes none.
     */
    default List<PerceptKind> perceptKinds() {
        return List.of();
    }

    /**
     * Carries out a command, as {@code ledOn} or {@code speed(3)}.
     *
     * @return whether the board knows the command; if not, a plan's {@code argo.act} fails with {@code error(act_refused)}, in version 2
     */
    boolean act(String command);

    /** Answers and acts until the port is closed. */
    @Override
    default void run(Transport line) throws PortException, InterruptedException {
        new SketchProgram(this, line).run();
    }
}
