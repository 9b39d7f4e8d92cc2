package benchmarks;

import argo.filters.format.XmlFilters;
import argo.filters.jason.LiteralTextKt;
import argo.filters.jason.PerceptReader;
import argo.filters.matching.PerceptMatcher;
import argo.filters.matching.PerceptMatcherKt;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.parser.ParseException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The cost of one percept: dropping it, reading it, and both with Jason's own parser. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 8, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Fork(1)
public class FilterBenchmark {
    private static final String ON_TEMP = "<filter><predicate>temp</predicate></filter>";
    private static final String NOT_FRONT =
            "<filter><predicate>dist</predicate><parameter operator=\"NE\" id=\"0\">f</parameter></filter>";

    private final PerceptMatcher byPredicate = matcher(ON_TEMP);
    private final PerceptMatcher byArgument = matcher(NOT_FRONT);
    private final PerceptMatcher tenRules = matcher(ON_TEMP + otherRules(9));
    private final PerceptMatcher thousandRules = matcher(ON_TEMP + otherRules(999));
    private String temp = "temp(r,36)";
    private String dist = "dist(r,227)";

    private static PerceptMatcher matcher(String rules) {
        String filter = "<PerceptionFilter>" + rules + "</PerceptionFilter>";
        return PerceptMatcherKt.matcher(XmlFilters.INSTANCE.read(filter, "benchmark.xml", "benchmark"));
    }

    private static String otherRules(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> "<filter><predicate>sensor" + i + "</predicate></filter>")
                .collect(Collectors.joining());
    }

    @Benchmark
    public boolean dropByPredicate() {
        return byPredicate.drops(temp, 0, temp.length());
    }

    @Benchmark
    public boolean dropByArgument() {
        return byArgument.drops(dist, 0, dist.length());
    }

    @Benchmark
    public boolean dropByOneOf10Rules() {
        return tenRules.drops(temp, 0, temp.length());
    }

    @Benchmark
    public boolean dropByOneOf1000Rules() {
        return thousandRules.drops(temp, 0, temp.length());
    }

    @Benchmark
    public boolean dropAfterJasonsParser() throws ParseException {
        return byArgument.drops(LiteralTextKt.perceptText(ASSyntax.parseLiteral(dist)));
    }

    @Benchmark
    public Literal readWithJasonsParser() throws ParseException {
        return ASSyntax.parseLiteral(dist);
    }

    @Benchmark
    public Literal readKept() {
        return PerceptReader.read(dist);
    }
}
