package javino.tcp;

import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;

/** Runs system calls that no interrupt ends, each on a thread of its own: callers can give up waiting. */
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
