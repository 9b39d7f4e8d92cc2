package javino.sim;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javino.LineClock;
import javino.PerceptKind;
import javino.PerceptTerm;
import javino.PerceptsRequest;
import javino.PortException;
import javino.Protocol;
import javino.Transport;
import javino.wire.BoardAction;

/** Runs a {@link Sketch} for one opening of its port. */
final class SketchProgram implements BoardProgram {
    private final Sketch sketch;
    private final BoardLoop loop;

    SketchProgram(Sketch sketch, Transport line, LineClock clock, int rules) {
        this.sketch = sketch;
        loop = new BoardLoop(line, this, Protocol.AUTO, BoardSession.Capacity.FULL.withRules(rules), clock);
    }

    void run() throws PortException, InterruptedException {
        loop.run();
    }

    @Override
    public List<BoardAction> vocabulary() {
        return sketch.actions();
    }

    @Override
    public List<PerceptKind> perceptKinds() {
        return sketch.perceptKinds();
    }

    @Override
    public Outcome carryOut(String command) {
        return sketch.act(command) ? Outcome.DONE : Outcome.REFUSED;
    }

    @Override
    public String percepts(String request) throws PortException, InterruptedException {
        Set<String> functors = PerceptsRequest.functorsIn(request);
        return loop.sayBeginning(message(sketch.percepts(), functors));
    }

    @Override
    public String sensors() {
        return message(sketch.sensors(), Set.of());
    }

    /** Returns a message with the percepts of the given functors. An empty set means all percepts. */
    private static String message(List<String> percepts, Set<String> functors) {
        return percepts.stream()
                .map(percept -> percept + ";")
                .filter(percept -> functors.isEmpty() || functors.contains(asked(percept)))
                .collect(Collectors.joining());
    }

    /** Returns a percept's functor without {@code ~}, because requests name functors without it. */
    private static String asked(String percept) {
        String functor = PerceptTerm.of(percept).functor();
        return functor.startsWith("~") ? functor.substring(1) : functor;
    }
}
