package argo.fleet.cluster

import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.TimeUnit

/** A loop on a daemon thread called [name]. */
internal class ThreadLoop(name: String) : Loop {
    private val executor = ScheduledThreadPoolExecutor(1) { Thread(it, name).apply { isDaemon = true } }

    override fun now(): Long = System.nanoTime()

    override fun execute(task: () -> Unit) = after(0, task)

    override fun after(millis: Long, task: () -> Unit) = try {
        executor.schedule({ guarded(task) }, millis, TimeUnit.MILLISECONDS)
        Unit
    } catch (e: RejectedExecutionException) {
        LOG.log(System.Logger.Level.DEBUG, "the cluster is closed", e)
    }

    /** Runs [task] and logs its exception or error. The executor would keep it for a caller that never asks. */
    private fun guarded(task: () -> Unit) = try {
        task()
    } catch (@Suppress("TooGenericExceptionCaught") e: Throwable) {
        LOG.log(System.Logger.Level.ERROR, "a task of the cluster failed", e)
    }

    override fun close() = executor.shutdown()

    private companion object {
        val LOG: System.Logger = System.getLogger(Cluster::class.java.name)
    }
}
