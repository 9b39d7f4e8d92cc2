package javino;

import java.util.concurrent.locks.Condition;

/** {@link System#nanoTime}. */
enum SystemLineClock implements LineClock {
    INSTANCE;

    @Override
    public long nanos() {
        return System.nanoTime();
    }

    @Override
    public void await(Condition condition, long nanos) throws InterruptedException {
        condition.awaitNanos(nanos);
    }
}
