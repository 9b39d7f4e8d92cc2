package javino.sim;

import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import javino.Frame;

/**
 * Finds frames of version 1 on a line that version 2 may share. A frame is handed over with its last byte; its bytes are kept until a
 * header or a silence behind it confirms it. Else it may have been misread, and its bytes but the first are read again. One thread at a
 * time.
 */
final class Version1Window {
    private static final String PREAMBLE = "fffe";

    private enum Header {
        IMPOSSIBLE,
        UNFINISHED,
        COMPLETE
    }

    private final int other;
    private final Consumer<Frame> found;
    private final StringBuilder window = new StringBuilder();
    private int delivered; // bytes at the window's start of a frame that was handed over
    private boolean isAnywhere = true;
    private boolean isQuiet = true;

    /**
     * @param other the byte with which frames of version 2 begin, outside of payloads of version 1; -1: there are none
     * @param found is given each frame, and may call {@link #anywhere}
     */
    Version1Window(int other, Consumer<Frame> found) {
        this.other = other;
        this.found = found;
    }

    /** Returns whether a frame may begin at any byte from now on, or only at one in front of which it was {@link #quiet}. */
    void anywhere(boolean value) {
        isAnywhere = value;
    }

    /** Returns whether a frame may begin with the next byte. */
    void quiet(boolean value) {
        isQuiet = value;
    }

    /** Returns whether a frame is being read. */
    boolean isReading() {
        return window.length() > delivered;
    }

    boolean isEmpty() {
        return window.isEmpty();
    }

    /** Takes a byte; returns the bytes from the first on that begins a frame of version 2, which are not kept. */
    String put(byte octet) {
        window.append((char) (octet & 0xFF));
        return read();
    }

    /**
     * Ends the input: an incomplete frame is read again from its second byte. Call it until it {@link #isEmpty}. Returns as {@link #put}.
     */
    String giveUp() {
        if (delivered > 0 && (!isReading() || header(delivered) == Header.COMPLETE)) {
            drop(delivered);
        } else {
            misread();
        }
        return read();
    }

    private String read() {
        boolean isDecided = true;
        while (isDecided && !window.isEmpty()) {
            if (window.charAt(0) == other) {
                String rest = window.toString();
                drop(window.length());
                return rest;
            }
            isDecided = delivered > 0 ? confirmOrDoubt() : deliverOrSkip();
        }
        return "";
    }

    /** Returns whether anything was decided, as does the next method. */
    private boolean confirmOrDoubt() {
        boolean isOther = isReading() && window.charAt(delivered) == other;
        switch (isOther ? Header.COMPLETE : header(delivered)) {
            case UNFINISHED -> {
                return false;
            }
            case COMPLETE -> drop(delivered);
            case IMPOSSIBLE -> misread();
        }
        return true;
    }

    private boolean deliverOrSkip() {
        Header header = isQuiet ? header(0) : Header.IMPOSSIBLE;
        if (header == Header.IMPOSSIBLE) {
            misread();
            return true;
        }
        int length = header == Header.UNFINISHED
                ? Integer.MAX_VALUE
                : Frame.HEADER_LENGTH + Integer.parseInt(window.substring(PREAMBLE.length(), Frame.HEADER_LENGTH), 16);
        if (window.length() < length) {
            return false;
        }
        delivered = length;
        found.accept(Frame.of(window.substring(Frame.HEADER_LENGTH, length).getBytes(StandardCharsets.ISO_8859_1)));
        isQuiet = isAnywhere;
        return true;
    }

    private void misread() {
        drop(1);
        isQuiet = isAnywhere;
    }

    private void drop(int count) {
        window.delete(0, count);
        delivered = 0;
    }

    private Header header(int from) {
        int known = Math.min(window.length() - from, Frame.HEADER_LENGTH);
        for (int i = 0; i < known; i++) {
            char c = window.charAt(from + i);
            if (i < PREAMBLE.length() ? c != PREAMBLE.charAt(i) : Character.digit(c, 16) < 0) {
                return Header.IMPOSSIBLE;
            }
        }
        return known == Frame.HEADER_LENGTH ? Header.COMPLETE : Header.UNFINISHED;
    }
}
