package javino;

import java.util.concurrent.TimeUnit;

/**
 * Finds out which version a board speaks. It is asked in version 2, twice in case the line damages one; a version 1 board discards that.
 * If there is no answer it is left a time in which boards in the field forget what they have begun to receive, and asked in version 1.
 *
 * <p>A version 2 board that was starting when it was asked in version 2 answers the request of version 1, in version 1. So one that did not
 * answer the first of these, or had something else to say before, is asked in version 2 once more, now that it runs. A board
 * that runs is asked in version 2 at one time only, and a board that starts at one more. What is not noticed is a version 2 board that
 * starts in silence after the last probe and in less than the gap behind it; it is spoken to in version 1, which works as well.
 *
 * <p>One thread at a time, but for {@link #version1From}.
 */
final class Negotiation {
    private static final int PROBES = 2;
    /** So many if bytes come back, which may be a damaged answer. */
    private static final int MAX_PROBES = 5;
    /** A board that takes longer to begin its answer is probed twice and answers twice. */
    private static final long PROBE_NANOS = TimeUnit.MILLISECONDS.toNanos(30);
    /** An answer that is coming is complete by then. */
    private static final long ANSWER_NANOS = TimeUnit.MILLISECONDS.toNanos(250);
    /** Boards in the field drop a frame 300 ms after its first byte. */
    private static final long GAP_NANOS = TimeUnit.MILLISECONDS.toNanos(310);
    /** While a board is starting, every so many requests one is of version 2, for a board that knows nothing else. */
    private static final int CYCLE = 4;

    private final RequestChannel channel;
    private final Inbox inbox;
    private final ResponseCorrelator answers;
    private final long gapNanos;
    private boolean probed;
    private int asked;
    private long overheard; // messages that came during probes and were no answers
    private volatile long version1From;

    /** @param settings of which the spacing is kept between the versions, if it is longer than boards in the field need */
    Negotiation(
            RequestChannel channel, Inbox inbox, ResponseCorrelator answers, LineClock clock, LinkSettings settings) {
        this.channel = channel;
        this.inbox = inbox;
        this.answers = answers;
        gapNanos = Math.max(GAP_NANOS, TimeUnit.MILLISECONDS.toNanos(settings.spacingMillis()));
        version1From = clock.nanos();
    }

    /** When a frame of version 1 may follow what was asked in version 2, by the link's clock. Any thread. */
    long version1From() {
        return version1From;
    }

    /** As {@link RequestChannel#request}; {@code answered} says whether the answer must be fresh. */
    Reply run(Frame request, int timeoutMillis, boolean answered) throws PortException {
        boolean runs = channel.hasHeard();
        Reply answer = null;
        if (!probed || runs) {
            probed = true;
            answer = probe(request, timeoutMillis);
        }
        if (answer == null && !runs) {
            boolean starting = channel.nanosUntilStarted() > 0;
            answer = channel.requestAsAgreed(request, timeoutMillis);
            if (answer == null && starting) {
                return probe(request, timeoutMillis); // the board may know nothing else
            }
            runs = asked == 1 && inbox.discardedBytes() == 0;
            if (answer == null || channel.protocol() != Protocol.AUTO) {
                return answer;
            }
            if (runs) {
                channel.agreeOn(Protocol.V1);
                return answer;
            }
            answer = probe(request, timeoutMillis);
        }
        if (answer != null) {
            return answer;
        }
        channel.agreeOn(Protocol.V1);
        return answered ? channel.requestAsAgreed(request, timeoutMillis) : null;
    }

    /** Writes a request while the version is not known. */
    long ask(Frame request, int timeoutMillis) throws PortException {
        asked++;
        return asked % CYCLE == 0 ? askVersion2(request, timeoutMillis) : askVersion1(request, timeoutMillis);
    }

    private long askVersion1(Frame request, int timeoutMillis) throws PortException {
        channel.awaitGap();
        return channel.ask(Protocol.V1, request, timeoutMillis);
    }

    private long askVersion2(Frame request, int timeoutMillis) throws PortException {
        long sent = channel.ask(Protocol.V2, request, timeoutMillis);
        version1From = sent + gapNanos;
        return sent;
    }

    private Reply probe(Frame request, int timeoutMillis) throws PortException {
        int most = PROBES;
        for (int probes = 1; probes <= most; probes++) {
            long sent = askVersion2(request, timeoutMillis);
            long deadline = sent + (probes < most ? PROBE_NANOS : GAP_NANOS);
            long messages = overheard;
            Reply answer = version2By(sent, deadline);
            if (answer != null) {
                return channel.completed(answer, timeoutMillis);
            }
            if (overheard == messages && inbox.lastByteNanos() - sent > 0) {
                most = MAX_PROBES;
            }
        }
        answers.oweNothingInVersion1();
        return null;
    }

    /** The next message of version 2, if it begins by {@code deadline}; what comes in version 1 meanwhile is no answer to a probe. */
    private Reply version2By(long sent, long deadline) throws PortException {
        Reply message = answers.by(sent, deadline, sent + ANSWER_NANOS);
        while (message != null && message.version() == Protocol.V1) {
            overheard++;
            channel.overhear(message);
            message = answers.by(sent, deadline, sent + ANSWER_NANOS);
        }
        return message;
    }
}
