package javino.sim;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javino.LineClock;
import javino.PerceptKind;
import javino.PerceptTerm;
import javino.PerceptsRequest;
import javino.PortException;
import javino.Transport;

/** Runs a {@link Sketch} for one opening of its port. */
final class SketchProgram implements BoardProgram {
    private final Sketch sketch;
    private final BoardLoop loop;

    SketchProgram(Sketch sketch, Transport line) {
        this.sketch = sketch;
        loop = new BoardLoop(line, this, LineClock.system());
    }

    void run() throws PortException, InterruptedException {
        loop.run();
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
        String answer = sketch.percepts().stream()
                .map(percept -> percept + ";")
                .filter(percept -> functors.isEmpty()
                        || functors.contains(PerceptTerm.of(percept).functor()))
                .collect(Collectors.joining());
        return loop.sayBeginning(answer);
    }
}
