package javino.sim;

import java.util.List;
import javino.LineClock;
import javino.PerceptKind;
import javino.PortException;
import javino.Transport;
import javino.wire.BoardAction;

/**
 * A simulated board made of two functions: one returns percepts, the other carries out commands. The sketch speaks both versions of the
 * protocol.
 *
 * <p>The sketch has the port {@code sim:NAME} if {@code META-INF/services/javino.sim.SimulatedBoard} names its class, or after
 * {@code SimulatedBoards.plugIn("NAME", sketch)}. One object serves all openings of the port. The board's thread calls both functions,
 * one at a time. While a function runs, the board does nothing else. If a function throws, the port is gone for its owner. The owner's
 * exception has the message.
 */
public interface Sketch extends SimulatedBoard {
    /** Returns the sensors' percepts: literals such as {@code dist(front,30)}, without a {@code ;}. Called for each request. */
    List<String> percepts();

    /**
     * Returns the kinds of the board's percepts: {@code PerceptKind.parseLines("dist(front|left, cm 0..400)")}. Tools, checks and the
     * live view use these kinds. Empty by default.
     */
    default List<PerceptKind> perceptKinds() {
        return List.of();
    }

    /**
     * Carries out a command, such as {@code ledOn} or {@code speed(3)}.
     *
     * @return true if the board knows the command. After false, a plan's {@code argo.act} fails in version 2 with
     *     {@code error(act_refused)}
     */
    boolean act(String command);

    /**
     * Returns the board's actions. Computers check commands against these actions; see {@link BoardProgram#vocabulary}. Empty by default.
     */
    default List<BoardAction> actions() {
        return List.of();
    }

    /** Returns the percepts that the board compares with its rules. Called every few milliseconds. By default {@link #percepts}. */
    default List<String> sensors() {
        return percepts();
    }

    /** Answers and acts until the port is closed. */
    @Override
    default void run(Transport line) throws PortException, InterruptedException {
        run(line, LineClock.system(), 0);
    }

    /**
     * Like {@link #run(Transport)}, but with another clock, and with critical rules.
     *
     * @param rules number of critical rules that the board can watch, 0 to 255
     */
    default void run(Transport line, LineClock clock, int rules) throws PortException, InterruptedException {
        new SketchProgram(this, line, clock, rules).run();
    }
}
