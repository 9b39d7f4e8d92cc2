package javino.session;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import javino.wire.FrameKind;
import javino.wire.WireFrame;

/** Chooses the nonces of sessions. A HELLO with such a nonce needs no escape, and holds no {@code f}, which begins a version 1 frame. */
final class Nonces {
    private static final List<Integer> USABLE = usable();

    private final RandomGenerator random;
    private int last = -1; // place of the last nonce among the usable ones; -1: none yet

    Nonces(RandomGenerator random) {
        this.random = random;
    }

    private static List<Integer> usable() {
        List<Integer> usable = new ArrayList<>();
        for (int nonce = 1; nonce <= 0xFF; nonce++) {
            byte[] bytes = hello(nonce).toBytes(0);
            boolean hasF = false;
            for (byte octet : bytes) {
                hasF |= octet == 'f';
            }
            if (!hasF && bytes.length == WireFrame.OVERHEAD) {
                usable.add(nonce);
            }
        }
        return usable;
    }

    static WireFrame hello(int nonce) {
        return WireFrame.of(FrameKind.HELLO, nonce, "");
    }

    /** Returns an unused nonce as long as there is one: a late WELCOME with an earlier nonce then answers no HELLO of this session. */
    int next() {
        last = (last < 0 ? random.nextInt(USABLE.size()) : last + 1) % USABLE.size();
        return USABLE.get(last);
    }
}
