package benchmarks;

import argo.filters.PerceptionFilter;
import argo.filters.format.XmlFilters;
import argo.filters.jason.PerceptReader;
import argo.filters.matching.FilterSession;
import jason.architecture.AgArch;
import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.Literal;
import jason.runtime.Settings;
import jason.util.Config;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures a reasoning cycle of a Jason agent, from the text of the percepts to the end of the cycle. Each value changes in each frame. The
 * agent has no filter, or one that keeps a single percept.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 6, time = 1)
@Fork(1)
public class CycleBenchmark {
    @Param({"12", "120", "1200"})
    private int percepts;

    @Param({"none", "one"})
    private String kept;

    private int frame;
    private TransitionSystem cycle;

    @Setup
    public void start() throws Exception {
        FilterSession<String> session = FilterSession.Companion.ofTexts();
        session.switchTo(kept.equals("one") ? keepOne() : null);
        AgArch arch = new AgArch() {
            private static final long serialVersionUID = 1L;

            @Override
            public Collection<Literal> perceive() {
                List<Literal> believed = new ArrayList<>();
                for (String percept : session.perceive(frame(), frame).getKept()) {
                    believed.add(PerceptReader.read(percept));
                }
                return believed;
            }
        };
        Config.get().put(Config.START_WEB_MI, "false"); // starts no web server
        Agent agent = new Agent();
        cycle = new TransitionSystem(agent, new Circumstance(), new Settings(), arch);
        agent.initAg();
    }

    private static PerceptionFilter keepOne() {
        return XmlFilters.INSTANCE.read(
                "<PerceptionFilter keep=\"true\"><filter><predicate>dist</predicate>"
                        + "<parameter operator=\"EQ\" id=\"0\">s0</parameter></filter></PerceptionFilter>",
                "one.xml",
                "one");
    }

    private List<String> frame() {
        frame++;
        return IntStream.range(0, percepts)
                .mapToObj(i -> "dist(s" + i + ',' + (frame + i) % 1000 + ')')
                .toList();
    }

    @Benchmark
    public int cycle() {
        cycle.reasoningCycle();
        return frame;
    }
}
