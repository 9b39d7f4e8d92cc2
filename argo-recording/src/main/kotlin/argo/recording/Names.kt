package argo.recording

import java.nio.file.Path

/** The version of what a recording of an agent holds; a reader refuses a newer one. */
const val FORMAT = "2"

/** The versions that are read. The first one wrote terms as Jason does. */
internal val FORMATS = setOf("1", FORMAT)

/** The name of the metadata of the agent called [name]. */
internal fun agentMetadata(name: String) = "agent/$name"

/** The name of the attachment with the filter [filter] of [agent]. */
internal fun filterName(agent: String, filter: String) = "filter/$agent/$filter.xml"

/** The name of the attachment with the file [file] of the program of [agent]. */
internal fun programName(agent: String, file: Path) = "program/$agent/${file.joinToString("/")}"
