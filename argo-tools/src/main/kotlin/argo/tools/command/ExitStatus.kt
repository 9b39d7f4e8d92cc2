package argo.tools.command

import argo.filters.FilterException
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException
import java.nio.file.NoSuchFileException

/** What a command tells the shell. */
internal object ExitStatus {
    const val DONE = 0
    const val FAILED = 1
    const val USAGE = 2
}

/** A command cannot do what it was asked; [message] says why to a person. */
internal class ToolException(message: String) : Exception(message)

/** What a person is told of [failure]; null if it is one that nobody foresaw. */
internal fun saidTo(failure: Throwable): String? = when (failure) {
    is ToolException, is FilterException -> failure.message
    is NoSuchFileException -> "there is no file ${failure.file}"
    is AccessDeniedException -> "${failure.file}: this user may not do that there"
    is javino.PortException -> failure.message
    is FileSystemException -> "${failure.file}: ${failure.reason ?: failure.javaClass.simpleName}"
    is IOException -> failure.message ?: "$failure"
    is UncheckedIOException -> failure.cause?.let(::saidTo)
    else -> null
}
