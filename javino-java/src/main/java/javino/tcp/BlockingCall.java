package javino.tcp;

import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;

/** Runs uninterruptible system calls on their own threads. Callers can then give up waiting. */
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
