package experiment

import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Path
import java.nio.file.StandardOpenOption

/**
 * Locks the [directory] of an experiment until the channel is closed. The operating system ends the lock with the program, however that
 * ends.
 *
 * @throws ContinuationException if another experiment has the lock
 */
internal fun claim(directory: Path): FileChannel {
    // No other code opens this file, since closing it would end the lock.
    val channel = FileChannel.open(directory.resolve(".lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)
    val lock = try {
        channel.tryLock()
    } catch (_: OverlappingFileLockException) {
        null // another experiment of this program has the lock
    }
    if (lock != null) return channel
    channel.close()
    throw ContinuationException(
        "an experiment is being made in $directory right now; wait for its end, or choose another directory with --out",
    )
}
