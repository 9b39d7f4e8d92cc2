package javino.sim;

import java.util.List;
import javino.LineClock;
import javino.PerceptKind;
import javino.PortException;
import javino.Transport;
import javino.wire.BoardAction;

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

    /** Returns its actions, by which computers check commands: {@link BoardProgram#vocabulary}. Unless overridden, it tells none. */
    default List<BoardAction> actions() {
        return List.of();
    }

    /** Returns the percepts that rules on the board are compared with, every few milliseconds; unless overridden, {@link #percepts}. */
    default List<String> sensors() {
        return percepts();
    }

    /** Answers and acts until the port is closed. */
    @Override
    default void run(Transport line) throws PortException, InterruptedException {
        run(line, LineClock.system(), 0);
    }

    /**
     * Like {@link #run(Transport)}, for a board that watches critical rules, or on a line with a clock of its own.
     *
     * @param clock the line's
     * @param rules the number of rules that the board can watch, 0 to 255
     */
    default void run(Transport line, LineClock clock, int rules) throws PortException, InterruptedException {
        new SketchProgram(this, line, clock, rules).run();
    }
}
