package argo.tools.command

import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.toPath

/** The jar that this program runs from; null: it runs from a folder of classes. */
internal fun ownJar(): Path? =
    ToolCommand::class.java.protectionDomain.codeSource.location.toURI().toPath().takeIf { it.isRegularFile() }
