package benchmarks;

import argo.filters.format.XmlFilters;
import argo.filters.jason.LiteralTextKt;
import argo.filters.jason.PerceptReader;
import argo.filters.matching.FilterSession;
import argo.filters.matching.PerceptMatcher;
import argo.filters.matching.PerceptMatcherKt;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.parser.ParseException;
import java.util.List;
import java.util.Random;
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

/** Measures dropping a percept, reading a percept, and both with Jason's own parser. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 8, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Fork(1)
public class FilterBenchmark {
    static final int MESSAGE = 12;

    private static final String ON_TEMP = "<filter><predicate>temp</predicate></filter>";
    private static final String NOT_FRONT =
            "<filter><predicate>dist</predicate><parameter operator=\"NE\" id=\"0\">f</parameter></filter>";

    private static final String NOT_BACK =
            "<filter><predicate>dist</predicate><parameter id=\"0\">b</parameter></filter>";

    private final PerceptMatcher byPredicate = matcher(ON_TEMP);
    private final PerceptMatcher byArgument = matcher(NOT_FRONT);
    private final PerceptMatcher tenRules = matcher(ON_TEMP + otherRules(9));
    private final PerceptMatcher thousandRules = matcher(ON_TEMP + otherRules(999));
    private final FilterSession<String> filtered = session(NOT_BACK);
    private final FilterSession<String> smoothed = session(smoothing("median=\"5\"") + NOT_BACK);
    private final FilterSession<String> withoutOutliers = session(smoothing("outliers=\"3\"") + NOT_BACK);
    private final FilterSession<String> smoothedTwice = session(smoothing("outliers=\"3\" median=\"3\"") + NOT_BACK);
    private final FilterSession<String> limit = session(NOT_BACK + beyond("400", ""));
    private final FilterSession<String> until = session(NOT_BACK + beyond("400", "until=\"300\""));
    private final FilterSession<String> untilMet = session(NOT_BACK + beyond("106", "until=\"101\""));
    private final List<List<String>> messages = messages();
    private int next;
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

    private static FilterSession<String> session(String rules) {
        FilterSession<String> session = FilterSession.Companion.ofTexts();
        session.switchTo(XmlFilters.INSTANCE.read(
                "<PerceptionFilter>" + rules + "</PerceptionFilter>", "benchmark.xml", "benchmark"));
        return session;
    }

    private static String smoothing(String how) {
        return "<smooth><predicate>dist</predicate><parameter id=\"1\" " + how + "/></smooth>";
    }

    private static String beyond(String limit, String until) {
        return "<filter><predicate>dist</predicate><parameter id=\"1\" operator=\"GT\" " + until + ">" + limit
                + "</parameter></filter>";
    }

    private static List<List<String>> messages() {
        Random random = new Random(1);
        return IntStream.range(0, 64)
                .mapToObj(i -> IntStream.range(0, MESSAGE)
                        .mapToObj(sensor -> "dist(s" + sensor + ','
                                + (random.nextInt(20) == 0 ? 399 : 100 + random.nextInt(9)) + ')')
                        .toList())
                .toList();
    }

    private int perceive(FilterSession<String> session) {
        next = (next + 1) % messages.size();
        return session.perceive(messages.get(next), next).getKept().size();
    }

    @Benchmark
    public int perceive() {
        return perceive(filtered);
    }

    @Benchmark
    public int perceiveSmoothed() {
        return perceive(smoothed);
    }

    @Benchmark
    public int perceiveWithoutOutliers() {
        return perceive(withoutOutliers);
    }

    @Benchmark
    public int perceiveSmoothedTwice() {
        return perceive(smoothedTwice);
    }

    @Benchmark
    public int perceiveLimit() {
        return perceive(limit);
    }

    @Benchmark
    public int perceiveUntil() {
        return perceive(until);
    }

    /** The numbers of most sensors are close to the two limits, and often cross one. */
    @Benchmark
    public int perceiveUntilMet() {
        return perceive(untilMet);
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
