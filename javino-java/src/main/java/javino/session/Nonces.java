package javino.session;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import javino.wire.FrameKind;
import javino.wire.WireFrame;

/**
 * Chooses the nonces of sessions. HELLO with a chosen nonce needs no escape. HELLO with a chosen nonce contains no {@code f}, because
 * {@code f} begins frames of version 1.
 */
final class Nonces {
    private static final List<Integer> USABLE =
            IntStream.rangeClosed(1, 0xFF).filter(Nonces::isUsable).boxed().toList();

    private final RandomGenerator random;
    private int last = -1; // index of the last chosen nonce, or -1

    Nonces(RandomGenerator random) {
        this.random = random;
    }

    private static boolean isUsable(int nonce) {
        String hello = new String(hello(nonce).toBytes(0), StandardCharsets.ISO_8859_1);
        return hello.indexOf('f') < 0 && hello.length() == WireFrame.OVERHEAD;
    }

    static WireFrame hello(int nonce) {
        return WireFrame.of(FrameKind.HELLO, nonce, "");
    }

    /** Returns an unused nonce, as long as there is one. A late WELCOME has an earlier nonce, so it cannot answer a new HELLO. */
    int next() {
        last = (last < 0 ? random.nextInt(USABLE.size()) : last + 1) % USABLE.size();
        return USABLE.get(last);
    }
}
