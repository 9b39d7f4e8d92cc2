package argo.recording

import jason.util.Config
import java.nio.file.Path

/** The version of the content of agents' recordings; a reader refuses a newer one. */
const val FORMAT = "2"

/** The versions that this program reads. Version 1 wrote terms as Jason does. */
internal val FORMATS = setOf("1", FORMAT)

internal fun agentMetadata(name: String) = "agent/$name"

/** Returns the name of the metadata of the file that [agent] included as its [number]th. */
internal fun includeMetadata(agent: String, number: Int) = "include/$agent/$number"

/** Returns the name of the attachment with the filter [filter] of [agent]. */
internal fun filterName(agent: String, filter: String) = "filter/$agent/$filter.xml"

/** Returns true if the attachment called [name] is a file of an agent's program, and not the `.mas2j`. */
internal fun isProgram(name: String) = name.startsWith("program/") && '/' in name.removePrefix("program/")

/** Returns the name of the attachment with the file [file] of the program of [agent]. */
internal fun programName(agent: String, file: Path) = "program/$agent/${file.joinToString("/")}"

/** Settings of Jason's for all agents that change the agents' behaviour. */
internal val CONFIG = listOf(Config.SHORT_UNNAMED_VARS, Config.KQML_RECEIVED_FUNCTOR)
