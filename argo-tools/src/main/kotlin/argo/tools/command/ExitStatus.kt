package argo.tools.command

import argo.filters.FilterException
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException
import java.nio.file.NoSuchFileException

/** The exit statuses of commands. Wrong arguments give 2. */
object ExitStatus {
    const val DONE = 0

    const val FAILED = 1
}

/** Ends a failed command; [message] tells the user the reason. */
class ToolException(message: String) : Exception(message)

/** Returns the message of [failure] for the user, or null if the failure is unexpected. */
internal fun messageOf(failure: Throwable): String? = when (failure) {
    is ToolException, is FilterException -> failure.message
    is NoSuchFileException -> "there is no file ${failure.file}"
    is AccessDeniedException -> "${failure.file}: this user has no permission"
    is javino.PortException -> failure.message
    is FileSystemException -> "${failure.file}: ${failure.reason ?: failure.javaClass.simpleName}"
    is IOException -> failure.message ?: "$failure"
    is UncheckedIOException -> failure.cause?.let(::messageOf)
    else -> null
}
