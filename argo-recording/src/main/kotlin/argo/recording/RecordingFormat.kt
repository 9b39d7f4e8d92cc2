package argo.recording

import jason.util.Config
import java.nio.file.Path

/** The version of the content of agents' recordings. A reader refuses a newer version. */
const val FORMAT = "2"

/** The readable versions. Recordings of version 1 have terms in Jason's own notation. */
internal val FORMATS = setOf("1", FORMAT)

internal fun agentMetadata(name: String) = "agent/$name"

/** Returns the name of the metadata about a file that [agent] has included. [number] counts these files from 1. */
internal fun includeMetadata(agent: String, number: Int) = "include/$agent/$number"

internal fun filterName(agent: String, filter: String) = "filter/$agent/$filter.xml"

/** Returns true if the attachment called [name] is a file of an agent's program, not the `.mas2j`. */
internal fun isProgram(name: String) = name.startsWith("program/") && '/' in name.removePrefix("program/")

internal fun programName(agent: String, file: Path) = "program/$agent/${file.joinToString("/")}"

/** Jason's settings for all agents that change how agents behave. */
internal val CONFIG = listOf(Config.SHORT_UNNAMED_VARS, Config.KQML_RECEIVED_FUNCTOR)
