package javino.sim;

import java.util.List;
import javino.LineClock;
import javino.PerceptKind;
import javino.PortException;
import javino.Transport;
import javino.wire.BoardAction;

/**
 * A simulated board as two functions: one returns percepts, one carries out commands. The sketch speaks both versions of the protocol.
 *
 * <p>Like any {@link SimulatedBoard}, it has the port {@code sim:NAME} if {@code META-INF/services/javino.sim.SimulatedBoard} names its
 * class, or after {@code SimulatedBoards.plugIn("NAME", sketch)}. One object serves all openings of the port. The board's thread calls both
 * functions, one at a time. A function may take long: the board does nothing else in that time. If a function throws, the port is gone for
 * its owner, who gets the exception's message.
 */
public interface Sketch extends SimulatedBoard {
    /** Returns what the sensors show: literals such as {@code dist(front,30)}, without a {@code ;}. Called for each request. */
    List<String> percepts();

    /**
     * Returns the kinds of the board's percepts, for tools, checks and the live view:
     * {@code PerceptKind.parseLines("dist(front|left, cm 0..400)")}. By default, none.
     */
    default List<PerceptKind> perceptKinds() {
        return List.of();
    }

    /**
     * Carries out a command, as {@code ledOn} or {@code speed(3)}.
     *
     * @return true: the board knows the command; false: in version 2 a plan's {@code argo.act} fails with {@code error(act_refused)}
     */
    boolean act(String command);

    /** Returns the board's actions, by which computers check commands; see {@link BoardProgram#vocabulary}. By default, none. */
    default List<BoardAction> actions() {
        return List.of();
    }

    /** Returns the percepts to compare with the board's rules, every few milliseconds. By default, {@link #percepts}. */
    default List<String> sensors() {
        return percepts();
    }

    /** Answers and acts until the port is closed. */
    @Override
    default void run(Transport line) throws PortException, InterruptedException {
        run(line, LineClock.system(), 0);
    }

    /**
     * Like {@link #run(Transport)}, for a board that watches up to {@code rules} critical rules (0 to 255), or on a line with its own
     * clock.
     */
    default void run(Transport line, LineClock clock, int rules) throws PortException, InterruptedException {
        new SketchProgram(this, line, clock, rules).run();
    }
}
