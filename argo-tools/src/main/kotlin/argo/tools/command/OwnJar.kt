package argo.tools.command

import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.toPath

/** Returns the jar from which this program runs; null: it runs from a folder of classes. */
internal fun ownJar(): Path? =
    ToolCommand::class.java.protectionDomain.codeSource.location.toURI().toPath().takeIf { it.isRegularFile() }
