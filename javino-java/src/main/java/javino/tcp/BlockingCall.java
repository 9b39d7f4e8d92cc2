package javino.tcp;

import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;

/** Runs calls of the system that no interrupt ends, each on a thread of its own, so that callers can give up waiting for them. */
final class BlockingCall {
    private BlockingCall() {}

    static <T> FutureTask<T> start(String name, Callable<T> call) {
        FutureTask<T> task = new FutureTask<>(call);
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        return task;
    }
}
