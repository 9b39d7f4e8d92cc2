package javino;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The sequence numbers that this program's ports stopped at. A board that stays on while its port is closed and opened again remembers its
 * last action for some seconds, and would take one of the same number and text for a repetition. All links share this, for a port may
 * change its owner. Safe on any thread.
 */
final class LastSequences {
    private static final int MAX_PORTS = 1000;
    private static final Map<String, Integer> LAST = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Integer> eldest) {
            return size() > MAX_PORTS;
        }
    };

    private LastSequences() {}

    /** The number of the last action to the board on {@code port}; if there was none, {@code otherwise}. */
    static synchronized int of(String port, int otherwise) {
        return LAST.getOrDefault(port, otherwise);
    }

    /** Records that an action to the board on {@code port} has {@code sequence}. */
    static synchronized void used(String port, int sequence) {
        LAST.put(port, sequence);
    }
}
