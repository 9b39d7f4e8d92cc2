package javino.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.random.RandomGenerator;
import javino.wire.BoardAction;
import javino.wire.CommandItem;
import javino.wire.CriticalReport;
import javino.wire.FrameKind;
import javino.wire.VocabularyPage;
import javino.wire.Welcome;
import javino.wire.WireFrame;

/**
 * The computer's end of a line of version 2. The caller passes arriving frames to the session. Whenever the line is free, the caller asks
 * for the next frame to write. The order is: repetitions, a request for percepts, commands, a request for the board's vocabulary.
 * <p>A new session is closed and sends nothing. A session opens when {@link #open} is called, or when the board answers a {@link #hello}.
 * If a session ends, another begins, until {@link #close} or until the board falls silent. Not thread-safe.
 * @param <C> the type of the commands
 */
public final class ComputerSession<C extends SessionCommand> {
    private enum State {
        CLOSED,
        OPENING,
        OPEN
    }

    private static final long SECOND_HELLO_NANOS = TimeUnit.MILLISECONDS.toNanos(60);
    private static final long LATER_HELLO_NANOS = TimeUnit.MILLISECONDS.toNanos(250);
    private static final long BUSY_NANOS = TimeUnit.MILLISECONDS.toNanos(250);
    private static final long SILENCE_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final int SILENT_REPETITIONS = 4;
    /** The longest payload, in bytes, of a frame with several commands. */
    private static final int MAX_ROW = 32;

    private static final int NAK_DIVISOR = 3;
    /** The number of frames in a row with impossible numbers that shows that the board has left the session. */
    private static final int IMPOSSIBLE_NUMBERS = 16;

    private final long byteNanos;
    private final int answerLimit;
    private final SessionListener<C> listener;
    private final Nonces nonces;
    private final Window<C> window = new Window<>();
    private final RetransmissionTime timeout = new RetransmissionTime();
    private final PerceptRequests requests;
    private final Vocabulary vocabulary = new Vocabulary();

    private State state = State.CLOSED;
    private int nonce; // 0 until one is chosen
    private boolean isEnded; // whether a session with this nonce has ended
    private int hellos;
    private long helloAt;
    private Welcome welcome = Welcome.NO_SESSION;

    private boolean mustResume;
    private boolean isBusy;
    private boolean isTimed; // whether the retransmission timer runs, from timerFrom on
    private long timerFrom;
    private long repeatedAt;
    private boolean hasRepeated;
    private long heardAt; // time of the last valid frame, or the beginning of the wait for one
    private int silentRepetitions;
    private int impossibleNumbers; // number of frames in a row with an impossible number
    private FrameKind writing; // kind of the frame that next() returned last

    /**
     * @param byteNanos nanoseconds that a byte takes on the line
     * @param answerLimit the most bytes of an answer
     * @param random chooses nonces
     */
    public ComputerSession(long byteNanos, int answerLimit, RandomGenerator random, SessionListener<C> listener) {
        this.byteNanos = byteNanos;
        this.answerLimit = answerLimit;
        this.listener = listener;
        nonces = new Nonces(random);
        requests = new PerceptRequests(byteNanos);
    }

    /** Returns the session's nonce. The checksums of the session's frames contain the nonce. Returns 0 if there is no session. */
    public int nonce() {
        return state == State.OPEN ? nonce : 0;
    }

    /** Returns whether the board has answered HELLO and is not known to have restarted since. */
    public boolean isOpen() {
        return state == State.OPEN;
    }

    /** Returns whether the session expects a frame. Answers to requests do not count. */
    public boolean isExpecting() {
        return state == State.OPENING || window.size() > 0 || state == State.OPEN && vocabulary.isAwaited();
    }

    /** Returns whether the board has acknowledged or answered everything. */
    public boolean isSettled() {
        return window.size() == 0 && requests.bytes() == 0;
    }

    /** Begins to send HELLO, and repeats it until the board answers. */
    public void open(long now) {
        if (state == State.CLOSED) {
            begin(State.OPENING, now);
        }
    }

    /** Ends the session and sends nothing more. Unacknowledged commands end as unconfirmed. */
    public void close(long now) {
        end(State.CLOSED, now);
    }

    /** Returns a HELLO that may begin a session. The board may speak either version. */
    public WireFrame hello() {
        if (nonce == 0 || isEnded) {
            renew();
        }
        return Nonces.hello(nonce);
    }

    private void renew() {
        nonce = nonces.next();
        isEnded = false;
    }

    /** Records that a frame of version 1 goes out. A frame of version 1 ends the board's session, so another session must follow. */
    public void sendsVersion1(long now) {
        if (state == State.CLOSED) {
            isEnded = true;
        } else { // WELCOME arrived just before this frame went out
            end(State.OPENING, now);
        }
    }

    /** Returns the board's actions in the order of their numbers. Empty if the actions are not known yet. */
    public Optional<List<BoardAction>> vocabulary() {
        return vocabulary.actions();
    }

    /**
     * Asks for percepts until the answer is reported or {@link #cancelRequest} is called. Percepts that arrive before the request has
     * gone out do not count as the answer.
     *
     * @param functors empty for all percepts, or a list such as {@code (dist,light)}
     */
    public void request(String functors, long now) {
        requests.want(functors, now);
    }

    /** Stops asking for percepts. */
    public void cancelRequest() {
        requests.cancel();
    }

    /** Handles an arriving frame: WELCOME, or a frame of this session. */
    public void received(WireFrame frame, long now) {
        if (frame.kind() == FrameKind.WELCOME) {
            Welcome said = Welcome.read(frame.payload());
            if (said == null) {
                listener.unreadable(FrameKind.WELCOME);
            } else if (state == State.OPEN) {
                heard(now);
                if (said.nonce() != nonce) {
                    end(State.OPENING, now);
                }
            } else if (nonce != 0) {
                welcomed(said, frame, now);
            }
            return;
        }
        if (state == State.OPEN) {
            heard(now);
            acknowledge(frame, now);
        }
        if (state == State.OPEN) {
            handle(frame, now);
        }
    }

    /**
     * Handles a WELCOME without a session. Even a WELCOME for an earlier HELLO proves that the board speaks version 2. If the WELCOME
     * shows commands of this session, another computer uses the nonce.
     */
    private void welcomed(Welcome said, WireFrame frame, long now) {
        if (said.revision() != Welcome.REVISION) {
            listener.otherRevision(said.revision());
            return;
        }
        boolean isOwn = said.nonce() == nonce && !isEnded;
        boolean isNew = frame.number() == 0 && !frame.isRefused() && !frame.isBusy();
        if (isOwn && isNew) {
            welcome = said;
            state = State.OPEN;
            impossibleNumbers = 0;
            heard(now);
            listener.began(said);
        } else if (state == State.CLOSED) {
            begin(State.OPENING, now);
            listener.found();
        } else if (isOwn) {
            begin(State.OPENING, now);
        }
    }

    private void heard(long now) {
        heardAt = now;
        silentRepetitions = 0;
    }

    private void handle(WireFrame frame, long now) {
        switch (frame.kind()) {
            case PERCEPTS, PERCEPTS_PART, PERCEPTS_LAST -> {
                boolean wasWanted = requests.isWanted();
                requests.accept(frame, now, answerLimit, listener);
                if (wasWanted && !requests.isWanted()) {
                    vocabulary.want(now);
                }
            }
            case VOCABULARY -> {
                VocabularyPage page = VocabularyPage.read(frame.payload());
                if (page == null) {
                    listener.unreadable(frame.kind());
                } else if (!vocabulary.accept(page, now)) {
                    listener.undescribed(page.first(), page.total());
                }
            }
            case CRITICAL -> {
                CriticalReport report = CriticalReport.read(frame.payload());
                if (report == null) {
                    listener.unreadable(frame.kind());
                } else {
                    listener.reported(report);
                }
            }
            default -> {}
        }
    }

    private void acknowledge(WireFrame frame, long now) {
        int news = frame.number() - window.oldest() & 0xFF;
        if (news > window.size()) {
            if (++impossibleNumbers == IMPOSSIBLE_NUMBERS) {
                end(State.OPENING, now);
            }
            return;
        }
        impossibleNumbers = 0;
        boolean isNoMoreBusy = isBusy && !frame.isBusy();
        boolean wasBusy = isBusy;
        isBusy = frame.isBusy();
        if (!frame.isRefused()) {
            mustResume = false;
        }
        if (news == 0) {
            if (frame.kind() == FrameKind.ACK
                    && !isBusy
                    && window.size() > 0
                    && window.unsent() == window.size()
                    && !hasJustRepeated(now)) {
                window.repeat();
            }
            return;
        }
        List<Window.Entry<C>> handled = window.acknowledge(news, now);
        if (!wasBusy) {
            window.roundTrip().ifPresent(timeout::measured);
        }
        timeout.news();
        isTimed = window.size() > 0;
        timerFrom = now;
        mustResume = frame.isRefused();
        if (mustResume || isNoMoreBusy) {
            window.repeat();
        }
        for (int i = 0; i < news; i++) {
            boolean isRefused = i == news - 1 && frame.isRefused();
            Window.Entry<C> entry = handled.get(i);
            CommandOutcome refusal = wasBusy && i == 0 ? CommandOutcome.FAILED : CommandOutcome.REFUSED;
            CommandOutcome end = entry.isVoid ? CommandOutcome.UNCONFIRMED : CommandOutcome.DONE;
            listener.ended(entry.command, isRefused ? refusal : end);
        }
        if (window.size() == 0) {
            vocabulary.want(now);
        }
    }

    private boolean hasJustRepeated(long now) {
        return hasRepeated && now - repeatedAt < timeoutNanos() / NAK_DIVISOR;
    }

    /** Records that bytes have arrived. */
    public void receiving(long now) {
        requests.receiving(now);
    }

    /** Records that a frame with a wrong checksum has arrived. */
    public void damaged() {
        requests.damaged();
    }

    private void begin(State next, long now) {
        state = next;
        renew();
        hellos = 0;
        helloAt = now;
    }

    private void end(State next, long now) {
        List<Window.Entry<C>> lost = window.clear();
        requests.reset(now);
        vocabulary.reset();
        mustResume = false;
        isBusy = false;
        isTimed = false;
        hasRepeated = false;
        silentRepetitions = 0;
        timeout.news();
        begin(next, now);
        lost.forEach(entry -> listener.ended(entry.command, CommandOutcome.UNCONFIRMED));
    }

    /**
     * Returns the frame to write now, or null. The frame counts as sent. The caller then calls {@link #wrote}.
     *
     * @param waiting the commands that the frame may carry
     */
    public WireFrame next(long now, WaitingCommands<C> waiting) {
        if (state == State.OPEN) {
            checkTimer(now);
        }
        WireFrame frame =
                switch (state) {
                    case CLOSED -> null;
                    case OPENING -> helloAt - now <= 0 ? hello() : null;
                    case OPEN -> nextInSession(now, waiting);
                };
        writing = frame == null ? null : frame.kind();
        return frame;
    }

    private WireFrame nextInSession(long now, WaitingCommands<C> waiting) {
        WireFrame frame = window.unsent() < window.size() ? repetition(now) : null;
        if (frame == null && requestIsDue(now)) {
            frame = request(now);
        }
        if (frame == null && window.unsent() == window.size()) {
            frame = commands(now, waiting);
        }
        return frame == null && vocabulary.nanosUntilDue(now) == 0 ? vocabulary.next(now) : frame;
    }

    private boolean requestIsDue(long now) {
        return requests.nanosUntilDue(now) == 0
                && (window.size() == 0 || window.hasRoomFor(WireFrame.OVERHEAD + 1, 0, welcome.credit()));
    }

    private WireFrame request(long now) {
        if (requests.bytes() > 0) {
            silentRepetitions++; // the previous request has no answer yet
        } else if (window.size() == 0) {
            heardAt = now; // nothing was awaited until now
        }
        return requests.next(welcome.longestPayload(), nonce);
    }

    private void checkTimer(long now) {
        if (isSilent(now)) {
            end(State.CLOSED, now);
            listener.lapsed();
        } else if (isTimed && timerFrom + timeoutNanos() - now <= 0) {
            timeout.timedOut();
            silentRepetitions++;
            window.repeat();
            isTimed = false; // restarts when the repetition has gone out
        }
    }

    private boolean isSilent(long now) {
        return silentRepetitions >= SILENT_REPETITIONS && now - heardAt >= SILENCE_NANOS;
    }

    private long timeoutNanos() {
        long nanos = timeout.nanos(window.bytes() * byteNanos);
        return isBusy ? Math.max(BUSY_NANOS, nanos) : nanos;
    }

    private WireFrame repetition(long now) {
        int first = window.unsent();
        Row row = new Row(window.bytes() == 0);
        int place = first;
        for (; place < window.size(); place++) {
            Window.Entry<C> entry = window.get(place);
            if (!row.add(repetitionOf(entry))) {
                break;
            }
            if (entry.command.isOver()) {
                entry.isVoid = true;
            }
        }
        if (row.isEmpty()) {
            return null;
        }
        hasRepeated = true;
        repeatedAt = now;
        return row.frame(first, place, true, now);
    }

    private CommandItem repetitionOf(Window.Entry<C> entry) {
        boolean isVoid = entry.isVoid || entry.command.isOver();
        return isVoid ? new CommandItem.Nothing() : vocabulary.itemOf(entry.command);
    }

    private WireFrame commands(long now, WaitingCommands<C> waiting) {
        if (isSettled()) {
            heardAt = now; // nothing was awaited until now
        }
        Row row = new Row(isSettled());
        int first = window.size();
        for (C next = waiting.head(); next != null && !window.isFull(); next = waiting.head()) {
            if (isTooLong(next)) {
                waiting.begin();
                listener.ended(next, CommandOutcome.TOO_LONG);
                continue;
            }
            if (!row.add(vocabulary.itemOf(next))) {
                break;
            }
            waiting.begin();
            window.add(next);
        }
        return row.isEmpty() ? null : row.frame(first, window.size(), false, now);
    }

    private boolean isTooLong(C command) {
        return command.text().length() > CommandItem.MAX_TEXT
                || vocabulary.itemOf(command).payload().length() > welcome.longestPayload();
    }

    /** Returns the longest text of a command, or of a change of rules, that the board takes, in bytes. */
    public int longestText(boolean isRule) {
        int payload = welcome.longestPayload();
        return Math.max(0, payload - (isRule || payload > CommandItem.BY_NUMBER ? 2 : 1));
    }

    private final class Row {
        private final boolean isFirst; // no other command is unacknowledged, so this frame may exceed the credit
        private String payload = "";

        Row(boolean isFirst) {
            this.isFirst = isFirst;
        }

        /** Adds an item and returns true. If the frame or {@linkplain Window#hasRoomFor the board} has no room for it, returns false. */
        boolean add(CommandItem item) {
            String longer = payload + item.payload();
            boolean isAlone = payload.isEmpty();
            boolean fits = isAlone || longer.length() <= Math.min(MAX_ROW, welcome.longestPayload());
            int bytes = WireFrame.OVERHEAD + longer.length();
            for (int i = 0; i < longer.length(); i++) {
                bytes += longer.charAt(i) == 0xA4 || longer.charAt(i) == 0xA5 ? 1 : 0;
            }
            if (!fits || !(isAlone && isFirst) && !window.hasRoomFor(bytes, requests.bytes(), welcome.credit())) {
                return false;
            }
            payload = longer;
            return true;
        }

        boolean isEmpty() {
            return payload.isEmpty();
        }

        WireFrame frame(int first, int end, boolean isRepeated, long now) {
            FrameKind kind = first == 0 && mustResume ? FrameKind.COMMANDS_WITH_RESUME : FrameKind.COMMANDS;
            WireFrame frame = WireFrame.of(kind, window.oldest() + first & 0xFF, payload);
            window.sent(frame.toBytes(nonce).length, end, isRepeated, now);
            return frame;
        }
    }

    /** Records when the last byte of the frame from {@link #next} leaves the line. */
    public void wrote(long leavesAt) {
        if (writing == null) {
            return;
        }
        switch (writing) {
            case HELLO -> helloAt = leavesAt + (hellos++ == 0 ? SECOND_HELLO_NANOS : LATER_HELLO_NANOS);
            case ASK -> requests.left(leavesAt);
            case COMMANDS, COMMANDS_WITH_RESUME -> {
                window.left(leavesAt);
                if (window.size() > 0 && !isTimed) {
                    isTimed = true;
                    timerFrom = leavesAt;
                }
                if (hasRepeated) {
                    repeatedAt = Math.max(repeatedAt, leavesAt);
                }
            }
            default -> {}
        }
    }

    /** Returns the nanoseconds until {@link #next} has a frame if nothing arrives. Returns {@link Long#MAX_VALUE} if there will be none. */
    public long nanosUntilNext(long now, WaitingCommands<C> waiting) {
        return switch (state) {
            case CLOSED -> Long.MAX_VALUE;
            case OPENING -> Math.max(0, helloAt - now);
            case OPEN -> hasCommands(waiting) ? 0 : nanosUntilDue(now);
        };
    }

    private long nanosUntilDue(long now) {
        long untilRepetition = isTimed ? Math.max(0, timerFrom + timeoutNanos() - now) : Long.MAX_VALUE;
        long untilRequest = requests.nanosUntilDue(now);
        if (untilRequest == 0 && !requestIsDue(now)) {
            untilRequest = Long.MAX_VALUE; // the request waits for an acknowledgement
        }
        return Math.min(Math.min(untilRepetition, untilRequest), vocabulary.nanosUntilDue(now));
    }

    /** Returns whether a frame of commands is due, new or repeated. */
    private boolean hasCommands(WaitingCommands<C> waiting) {
        if (window.unsent() < window.size()) {
            return new Row(window.bytes() == 0).add(repetitionOf(window.get(window.unsent())));
        }
        C next = window.isFull() ? null : waiting.head();
        return next != null && (isTooLong(next) || new Row(isSettled()).add(vocabulary.itemOf(next)));
    }
}
