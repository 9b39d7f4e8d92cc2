package javino.sim;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import javino.Frame;
import javino.Protocol;

/** How a {@link FakeBoard} speaks: it answers in the version it was asked in, and acknowledges actions that want it. Safe on any thread. */
final class FakeBoardVoice {
    private final Protocol protocol;
    private int version = 1; // of what was heard last
    private int sequence;
    private Frame acted; // the last action that wanted to be acknowledged; null: there was none
    private boolean refused;

    /** @param protocol {@link Protocol#V1}, or {@link Protocol#AUTO}: both versions */
    FakeBoardVoice(Protocol protocol) {
        this.protocol = protocol;
    }

    /** The board begins anew. */
    synchronized void reset() {
        version = 1;
        sequence = 0;
        acted = null;
    }

    Protocol reads() {
        return protocol;
    }

    /** Takes the next frame: whether it is an action that has been handled, sent once more. */
    synchronized boolean isRepeated(Frame frame) {
        version = frame.version();
        return frame.has(Frame.ACK_WANTED) && frame.equals(acted);
    }

    synchronized void handled(Frame frame, boolean refused) {
        if (frame.has(Frame.ACK_WANTED)) {
            acted = frame;
            this.refused = refused;
        }
    }

    /** What tells of the outcome of the action that was handled; null if nobody wants to know. */
    synchronized byte[] outcome(Frame frame) {
        if (!frame.has(Frame.ACK_WANTED)) {
            return null;
        }
        return Frame.version2(new byte[0], refused ? Frame.REFUSAL : Frame.ACK, frame.sequence()).toBytes();
    }

    /** The bytes of a message that nobody asked for, in the version that was heard last. */
    synchronized byte[] message(String text) {
        return message(text, version);
    }

    /** The bytes of a message in this version. */
    synchronized byte[] message(String text, int version) {
        if (version == 1) {
            return Frame.of(text).toBytes();
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (Frame fragment : Frame.fragments(text.getBytes(StandardCharsets.ISO_8859_1), sequence)) {
            bytes.writeBytes(fragment.toBytes());
            sequence = (sequence + 1) % Frame.SEQUENCES;
        }
        return bytes.toByteArray();
    }
}
