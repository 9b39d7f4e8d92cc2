plugins { `java-library` }

dependencies {
    implementation(project(":javino-java"))
    implementation(project(":argo-filters-dsl"))
    implementation(project(":argo-recording"))
    implementation(libs.picocli)
    implementation(libs.serialization.json)
    testImplementation(project(":argo-testkit")) // tests record agents and replay them, and explore them
    testImplementation(libs.kotlin.compiler) // tests compile the specs that explorations print
    testImplementation(libs.jason)
}
