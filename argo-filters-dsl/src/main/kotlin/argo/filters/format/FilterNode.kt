package argo.filters.format

/** A value in a filter's document, with its position and its text for messages. XML and JSON documents are read into the same form. */
internal sealed class FilterNode(val position: Position, val words: String) {
    class Object(position: Position, val members: List<Member>) : FilterNode(position, "an object")

    class Array(position: Position, val items: List<FilterNode>) : FilterNode(position, "an array")

    /**
     * @property isText true if the scalar can be a text: in JSON, a scalar in quotes; in XML, every scalar
     * @property isBare true if the scalar can be a number or a truth value: in JSON, a scalar without quotes; in XML, every scalar
     */
    class Scalar(position: Position, val content: String, val isText: Boolean, val isBare: Boolean) :
        FilterNode(position, if (isText) "'$content'" else content)

    /** Replaces a missing or wrong value that has already been reported. */
    class Refused(position: Position) : FilterNode(position, "")

    class Member(val name: String, val position: Position, val value: FilterNode, val words: String = "\"$name\" is ${value.words}")
}
