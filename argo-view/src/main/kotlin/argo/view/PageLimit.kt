package argo.view

import java.util.concurrent.Semaphore

/** Limits the total number of open pages of all agents. Any thread may call the functions. */
internal class PageLimit {
    private val free = Semaphore(MAX_PAGES)

    /** Calls [watch] and returns true. If too many pages watch, returns false at once. */
    fun take(watch: () -> Unit): Boolean {
        if (!free.tryAcquire()) return false
        try {
            watch()
        } finally {
            free.release()
        }
        return true
    }

    private companion object {
        const val MAX_PAGES = 12
    }
}
